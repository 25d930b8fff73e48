// First half of a pass of the multi-scatter fixed point: radiance along each direction from each node of the table.
// The first pass gathers light scattered once (and sunlight off the ground); pass n gathers what the field of pass n - 1
// scatters once more (and its light off the ground). One invocation a ray: (mu_s node, altitude node and direction).
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, multi_scatter_table)
UNIFORMS(5, QuadratureBlock, zenith_quadrature)
IMAGE_2D(6, rays_out)
SPEC_INT(8, RAY_NODES, 6)
SPEC_BOOL(10, SINGLE_SCATTERING, true)
SPEC_BOOL(11, MULTIPLE_SCATTERING, false)
SPEC_BOOL(43, GROUND_LIGHT, true)  // what the ground reflects lights the air

#include "common/ground.glsl"
#include "common/march.glsl"
#include "multi_scatter/directions.glsl"
#include "phase/smooth_phase.glsl"

LOCAL_SIZE(32, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(rays_out);
    int rows = size.y / direction_count();
    if (id.x >= size.x || id.y >= size.y) return;
    int row = id.y % rows;
    real altitude = altitude_at(texel_to_unit(row, rows));
    real mu_s = sun_mu_at(texel_to_unit(id.x, size.x));
    ScatterDirection direction = scatter_direction(id.y / rows, altitude);

    Ray ray;
    ray.altitude = altitude;
    ray.mu = direction.mu;
    ray.mu_s = mu_s;
    real sines = sqrt(max((1 - direction.mu) * (1 + direction.mu) * (1 - mu_s) * (1 + mu_s), real(0)));
    ray.nu = clamp(direction.mu * mu_s + sines * direction.azimuth_cosine, real(-1), real(1));
    ray.ground = direction.ground;
    ray.end = ray.ground ? distance_to_ground(altitude, ray.mu) : distance_to_top(altitude, ray.mu);

    RayLight light = march(ray);
    vec3 radiance = light.multiple;
    if (SINGLE_SCATTERING)
        for (int c = 0; c < PHASE_COUNT; ++c) radiance += smooth_phase(c, ray.nu) * light.single[c];
    if (GROUND_LIGHT && ray.ground) {
        real ground_mu_s = sun_mu_after(ray, ray.end, real(0));
        radiance += ground_radiance(
            light.depth, SINGLE_SCATTERING ? ground_beam_irradiance(ground_mu_s) : ground_diffuse_irradiance(ground_mu_s));
    }
    imageStore(rays_out, ivec2(id.x, id.y), vec4(radiance, real(0)));
}
