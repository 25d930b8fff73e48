// Multiple scattering of Hillaire 2020, section 5.5, first half: for each node of the table, 64 directions x 20 steps of light
// scattered once with an isotropic phase (L_2nd) and of the share of light that scattering hands on (f_ms). One invocation a ray,
// the 64 rays of a node side by side in x. L_2nd of node n stands in row 2 n, f_ms in row 2 n + 1.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_TRANSMITTANCE_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
SAMPLER_2D(3, transmittance_table)
IMAGE_2D(6, rays_out)
SPEC_INT(8, RAY_STEPS, 20)
SPEC_INT(15, SUN_NODES, 32)

#include "common/geometry.glsl"
#include "common/slab.glsl"
#include "medium/medium.glsl"
#include "multi_scatter/multi_scatter.glsl"
#include "transmittance/transmittance.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(rays_out);
    if (id.x >= 64 || 2 * id.y >= size.y) return;
    int rows = size.y / (2 * SUN_NODES);
    real altitude = altitude_at(texel_to_unit(id.y / SUN_NODES, rows));
    real mu_s = sun_mu_at(texel_to_unit(id.y % SUN_NODES, SUN_NODES));
    real azimuth = 2 * PI * (real(id.x / 8) + real(0.5)) / real(8);
    real mu = 1 - 2 * (real(id.x % 8) + real(0.5)) / real(8);

    Ray ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = mu_s;
    ray.nu = mu * mu_s + sqrt(max((1 - mu * mu) * (1 - mu_s * mu_s), real(0))) * cos(azimuth);
    ray.ground = hits_ground(altitude, mu);
    ray.end = ray.ground ? distance_to_ground(altitude, mu) : distance_to_top(altitude, mu);

    vec3 depth = vec3(real(0));
    vec3 second = vec3(real(0));
    vec3 share = vec3(real(0));
    real before = real(0);
    for (int i = 0; i < RAY_STEPS; ++i) {
        real t = ray.end * (real(i) + real(0.3)) / real(RAY_STEPS);
        real step_km = t - before;
        before = t;
        real h = altitude_after(ray.altitude, ray.mu, t);
        Medium air = sample_medium(h);
        vec3 scattering = vec3(real(0));
        for (int c = 0; c < PHASE_COUNT; ++c) scattering += air.scattering[c];
        vec3 slab = air.extinction * step_km;
        vec3 scattered = exp(-depth) * mean_transmittance(slab) * step_km * scattering;
        second += scattered * transmittance_to_sun(h, sun_mu_after(ray, t, h)) / (4 * PI);
        share += scattered;
        depth += slab;
    }
    if (ray.ground) {
        real ground_mu_s = sun_mu_after(ray, ray.end, real(0));
        second += exp(-depth) * (vec3(atm.ground_albedo) / PI) * max(ground_mu_s, real(0)) * transmittance_to_sun(real(0), ground_mu_s);
    }
    imageStore(rays_out, ivec2(id.x, 2 * id.y), vec4(second, real(0)));
    imageStore(rays_out, ivec2(id.x, 2 * id.y + 1), vec4(share, real(0)));
}
