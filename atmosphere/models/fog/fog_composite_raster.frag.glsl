// The composite of fog, as a full-screen draw.
#include "composite/inputs.glsl"
#include "models/fog/fog_sky.glsl"
#include "composite/raster.glsl"
