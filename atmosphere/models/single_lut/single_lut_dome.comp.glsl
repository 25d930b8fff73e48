// The dome of single scattering by a table of optical depth.
#include "models/single/dome_inputs.glsl"
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(4, transmittance_table)
#include "models/single/dome.glsl"
