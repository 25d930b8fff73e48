// Psi (hillaire.glsl), first half: 8 x 8 rays from each node of the table, even over the sphere. One invocation a ray, the 64 rays
// of a node side by side in x. Their part of L_2nd of node n stands in row 2 n, of f_ms in row 2 n + 1.
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

#include "common/ground.glsl"
#include "models/hillaire/hillaire.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(rays_out);
    if (id.x >= 64 || 2 * id.y >= size.y) return;
    int rows = size.y / (2 * SUN_NODES);
    real altitude = psi_altitude(texel_to_unit(id.y / SUN_NODES, rows));
    real mu_s = psi_sun_mu(texel_to_unit(id.y % SUN_NODES, SUN_NODES));
    real azimuth = 2 * PI * (real(id.x / 8) + real(0.5)) / real(8);
    real mu = 1 - 2 * (real(id.x % 8) + real(0.5)) / real(8);

    Ray ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = mu_s;
    ray.nu = mu * mu_s + sqrt(max((1 - mu * mu) * (1 - mu_s * mu_s), real(0))) * cos(azimuth);
    ray.ground = hits_ground(altitude, mu);
    ray.end = ray.ground ? distance_to_ground(altitude, mu) : distance_to_top(altitude, mu);

    RayLight light = march_steps(ray, RAY_STEPS, false);
    vec3 second = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) second += light.single[c] / (4 * PI);
    if (ray.ground) second += ground_radiance(light.depth, ground_beam_irradiance(sun_mu_after(ray, ray.end, real(0))));
    imageStore(rays_out, ivec2(id.x, 2 * id.y), vec4(second, real(0)));
    imageStore(rays_out, ivec2(id.x, 2 * id.y + 1), vec4(light.multiple, real(0)));
}
