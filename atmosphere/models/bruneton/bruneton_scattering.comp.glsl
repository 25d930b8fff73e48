// Scattered light of all orders so far, over the 4D table: what the air scatters once, and what it scatters of the field that
// `source_table` holds, along the ray of each texel.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)
SAMPLER_2D(3, transmittance_table)
SAMPLER_3D(4, source_table)
CONST(bool, MULTIPLE_SCATTERING, true)

#include "models/bruneton/bruneton.glsl"

// What the field at a point sends into the ray: the source, which is per unit of scattering, times the scattering.
vec3 scattered_diffuse(real altitude, real mu, real mu_s, real nu, vec3 scattering[MAX_PHASES]) {
    vec3 whole = scattering[0];
    for (int c = 1; c < PHASE_COUNT; ++c) whole += scattering[c];
    Ray ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = mu_s;
    ray.nu = nu;
    // The source is continuous across the horizon, and near the ground all rays that go down fall into the nadir's row: a ray along the
    // horizon must not be taken for one of them by a rounding error.
    ray.ground = mu < horizon_mu(altitude) - real(1e-4);
    ray.end = real(0);
    TablePlace place = table_place(ray, textureSize(source_table, 0), 1);
    vec3 low = vec3(SAMPLE(source_table, place.at));
    vec3 high = vec3(SAMPLE(source_table, place.at + vec3(place.step, real(0), real(0))));
    return whole * mix(low, high, place.share);
}


#include "models/bruneton/bruneton_rays_of_texels.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) { scattering_texel(ivec3(id.x, id.y, id.z)); }
