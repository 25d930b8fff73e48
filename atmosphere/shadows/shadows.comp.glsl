// The losses by shadows, for models with a transmittance table.
#include "shadows/inputs.glsl"
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(3, transmittance_table)
#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"
#include "shadows/march.glsl"
