// Fills the sky-view table (sky_view.glsl): one ray a texel, marched once for all layers.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
#define AUREOLE_SKY_LIGHTS_GROUND
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, multi_scatter_table)
UNIFORMS(5, ViewBlock, view)
IMAGE_2D(6, sky_view_out)
SPEC_INT(8, RAY_NODES, 8)
CONST(bool, SINGLE_SCATTERING, true)
SPEC_BOOL(11, MULTIPLE_SCATTERING, true)  // false: multi_scatter_table is not read

#include "common/march.glsl"
#include "sky_view/sky_view.glsl"
#include "sky_view/sky_view_texel.glsl"

LOCAL_SIZE(32, 2, 1)

COMPUTE_MAIN(id) { sky_view_texel(ivec2(id.x, id.y)); }
