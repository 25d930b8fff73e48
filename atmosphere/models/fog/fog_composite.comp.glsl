// The composite of fog, as a compute pass.
#include "composite/inputs.glsl"
#include "models/fog/fog_sky.glsl"
#include "composite/compute.glsl"
