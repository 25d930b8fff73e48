// The composite with a march for each pixel, as a full-screen draw.
#include "composite/inputs.glsl"
#include "models/hillaire/hillaire_sky_light.glsl"
#include "composite/raster.glsl"
