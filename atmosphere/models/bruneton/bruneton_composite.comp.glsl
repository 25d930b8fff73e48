// The composite of the model bruneton, as a compute pass.
#include "composite/inputs.glsl"
#include "models/bruneton/bruneton_sky.glsl"
#include "composite/compute.glsl"
