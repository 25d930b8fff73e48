// The transmittance table by even steps, as published.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
UNIFORMS(0, AtmosphereBlock, atm)
IMAGE_2D(3, transmittance_out)
SPEC_INT(8, RAY_STEPS, 40)

#include "common/geometry.glsl"
#include "common/storage.glsl"
#include "medium/medium.glsl"
#include "models/hillaire/steps.glsl"
#include "transmittance/transmittance.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(transmittance_out);
    if (id.x >= size.x || id.y >= size.y) return;
    vec2 p = transmittance_altitude_mu(vec2(texel_to_unit(id.x, size.x), texel_to_unit(id.y, size.y)));
    real end = distance_to_top(p.x, p.y);
    vec3 depth = vec3(real(0));
    for (int i = 0; i < RAY_STEPS; ++i) {
        RayStep s = even_step(end, i, RAY_STEPS);
        depth += medium_extinction(altitude_after(p.x, p.y, s.t)) * s.dt;
    }
    imageStore(transmittance_out, ivec2(id.x, id.y), vec4(storable(depth), real(0)));
}
