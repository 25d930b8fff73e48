// The dome of single scattering.
#include "models/single/dome_inputs.glsl"
#include "models/single/nested.glsl"
#include "models/single/dome.glsl"
