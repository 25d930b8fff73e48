// The composite of the model bruneton, as a full-screen draw.
#include "composite/inputs.glsl"
#include "models/bruneton/bruneton_sky.glsl"
#include "composite/raster.glsl"
