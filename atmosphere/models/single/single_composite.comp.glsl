// The composite of single scattering, as a compute pass.
#include "composite/inputs.glsl"
#include "models/single/nested.glsl"
#include "models/single/single_sky.glsl"
#include "composite/compute.glsl"
