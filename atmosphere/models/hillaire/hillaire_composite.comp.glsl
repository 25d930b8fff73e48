// The composite with a march for each pixel, as a compute pass.
#include "composite/inputs.glsl"
#include "models/hillaire/hillaire_sky_light.glsl"
#include "composite/compute.glsl"
