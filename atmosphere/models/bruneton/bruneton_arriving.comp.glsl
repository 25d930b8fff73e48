// The field: radiance that arrives at each altitude and mu_s from each direction of a quadrature, times the direction's solid
// angle. The light that is scattered at a point depends on the direction into which it is scattered by the phase function alone, so
// what arrives there is looked up once instead of once for every (mu, nu) of the 4D table: a thousandth of the look-ups of the
// published way, for the same sum.
// x: mu_s, y: direction, z: altitude.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SCATTERING_TABLE
#define AUREOLE_IRRADIANCE_TABLE
#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, zenith_quadrature)
SAMPLER_3D(2, scattering_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, irradiance_table)
IMAGE_3D(6, arriving_out)

#include "models/bruneton/bruneton_directions.glsl"
#include "phase/phase.glsl"
#include "phase/smooth_phase.glsl"
// A few directions would miss an aerosol's peak, or count it double.
#define AUREOLE_SHARP_PHASE(c, nu) (PUBLISHED_STEPS ? phase_value(c, nu) : smooth_phase(c, nu))
#include "models/bruneton/bruneton_rays.glsl"

LOCAL_SIZE(32, 1, 1)

COMPUTE_MAIN(id) {
    ivec3 size = imageSize(arriving_out);
    if (id.x >= size.x || id.y >= size.y || id.z >= size.z) return;
    Ray ray;
    ray.altitude = altitude_at(texel_to_unit(id.z, size.z));
    ScatterDirection direction = arriving_direction(id.y, ray.altitude);
    ray.mu = direction.mu;
    ray.mu_s = sun_axis_mu(texel_to_unit(id.x, size.x));
    ray.nu = nu_of(ray.mu, ray.mu_s, direction.azimuth_cosine);
    ray.ground = direction.ground;
    ray.end = ray.ground ? distance_to_ground(ray.altitude, ray.mu) : distance_to_top(ray.altitude, ray.mu);
    imageStore(arriving_out, ivec3(id.x, id.y, id.z), vec4(direction.solid_angle * ray_radiance(ray), real(0)));
}
