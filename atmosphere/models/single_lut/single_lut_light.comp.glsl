// The light of single scattering by a table of optical depth.
#include "light/inputs.glsl"
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(4, transmittance_table)
#include "models/single/single_light.glsl"
#include "light/light.glsl"
