// The composite of single scattering by a table of optical depth, as a compute pass.
#include "composite/inputs.glsl"
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(4, transmittance_table)
#include "models/single/single_sky.glsl"
#include "composite/compute.glsl"
