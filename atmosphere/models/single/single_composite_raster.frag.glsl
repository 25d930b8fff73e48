// The composite of single scattering, as a full-screen draw.
#include "composite/inputs.glsl"
#include "models/single/nested.glsl"
#include "models/single/single_sky.glsl"
#include "composite/raster.glsl"
