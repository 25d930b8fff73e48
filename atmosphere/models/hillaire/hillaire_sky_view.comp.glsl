// The sky-view table by the published march, in one layer (all phase functions applied).
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, multi_scatter_table)
UNIFORMS(5, ViewBlock, view)
IMAGE_2D(6, sky_view_out)
SPEC_INT(8, RAY_STEPS, 30)

#include "models/hillaire/hillaire.glsl"

RayLight march(Ray ray) { return march_steps(ray, RAY_STEPS, true); }

#include "sky_view/sky_view.glsl"
#include "sky_view/sky_view_texel.glsl"

LOCAL_SIZE(32, 2, 1)

COMPUTE_MAIN(id) { sky_view_texel(ivec2(id.x, id.y)); }
