// The light of single scattering.
#include "light/inputs.glsl"
#include "models/single/nested.glsl"
#include "models/single/single_light.glsl"
#include "light/light.glsl"
