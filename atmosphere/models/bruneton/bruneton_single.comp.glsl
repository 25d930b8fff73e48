// Light scattered once, over the 4D table.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)
SAMPLER_2D(3, transmittance_table)
CONST(bool, MULTIPLE_SCATTERING, false)

#include "models/bruneton/bruneton.glsl"

vec3 scattered_diffuse(real, real, real, real, vec3[MAX_PHASES]) { return vec3(real(0)); }

#include "models/bruneton/bruneton_rays_of_texels.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) { scattering_texel(ivec3(id.x, id.y, id.z)); }
