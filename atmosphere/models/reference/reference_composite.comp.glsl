// The composite of the path tracer, as a compute pass.
#include "composite/inputs.glsl"
#include "models/reference/reference_sky.glsl"
#include "composite/compute.glsl"
