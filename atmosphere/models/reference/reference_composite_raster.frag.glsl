// The composite of the path tracer, as a full-screen draw.
#include "composite/inputs.glsl"
#include "models/reference/reference_sky.glsl"
#include "composite/raster.glsl"
