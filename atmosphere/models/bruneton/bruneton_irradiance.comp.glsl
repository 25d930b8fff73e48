// Indirect irradiance: what the sky gives a level surface, over mu_s (x) and altitude (y). The direct irradiance needs no table:
// it is the sun's cosine times the transmittance (ground_beam_irradiance).
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SCATTERING_TABLE
#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, zenith_quadrature)
SAMPLER_3D(2, scattering_table)
SAMPLER_2D(3, transmittance_table)
IMAGE_2D(6, irradiance_out)
SPEC_INT(12, ZENITH_NODES, 6)
SPEC_INT(13, AZIMUTH_NODES, 8)
SPEC_BOOL(32, PUBLISHED_STEPS, false)

#include "phase/phase.glsl"
#include "phase/smooth_phase.glsl"
#define AUREOLE_SHARP_PHASE(c, nu) (PUBLISHED_STEPS ? phase_value(c, nu) : smooth_phase(c, nu))
#include "models/bruneton/bruneton_rays.glsl"

struct Share {
    vec4 share;  // x: 1, or 0 before anything has been scattered
};
PUSH_CONSTANTS(Share, given)

LOCAL_SIZE(16, 1, 1)

// Of the upper hemisphere: cosine of the zenith angle, and the weight of one azimuth, the surface's cosine included.
vec2 zenith_node(int i) {
    if (PUBLISHED_STEPS) {
        real step_angle = real(0.5) * PI / real(ZENITH_NODES);
        real angle = step_angle * (real(i) + real(0.5));
        return vec2(cos(angle), cos(angle) * sin(angle) * step_angle * 2 * PI / real(AZIMUTH_NODES));
    }
    real mu = zenith_quadrature.node[i].x;
    return vec2(mu, mu * zenith_quadrature.node[i].y * 2 * PI / real(AZIMUTH_NODES));
}

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(irradiance_out);
    if (id.x >= size.x || id.y >= size.y) return;
    Ray ray;
    ray.altitude = altitude_at(texel_to_unit(id.y, size.y));
    ray.mu_s = sun_axis_mu(texel_to_unit(id.x, size.x));
    ray.ground = false;
    vec3 sum = vec3(real(0));
    for (int i = 0; i < ZENITH_NODES; ++i) {
        vec2 node = zenith_node(i);
        ray.mu = node.x;
        ray.end = real(0);
        for (int k = 0; k < AZIMUTH_NODES; ++k) {
            ray.nu = nu_of(ray.mu, ray.mu_s, cos(PI * (real(k) + real(0.5)) / real(AZIMUTH_NODES)));
            sum += node.y * air_radiance(scattering_place(ray), ray.nu);
        }
    }
    imageStore(irradiance_out, ivec2(id.x, id.y), vec4(given.share.x * max(sum, vec3(real(0))), real(0)));
}
