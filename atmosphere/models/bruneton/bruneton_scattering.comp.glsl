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
IMAGE_3D(6, scattering_out)
SPEC_INT(8, RAY_NODES, 6)
CONST(bool, SINGLE_SCATTERING, true)
SPEC_BOOL(11, MULTIPLE_SCATTERING, false)
SPEC_BOOL(32, PUBLISHED_STEPS, false)

#include "models/bruneton/bruneton.glsl"
#include "models/bruneton/slices.glsl"

// What the field at a point sends into the ray: the source, which is per unit of scattering, times the scattering.
vec3 scattered_diffuse(real altitude, real mu, real mu_s, real nu, vec3 scattering[MAX_PHASES]) {
    vec3 whole = scattering[0];
    for (int c = 1; c < PHASE_COUNT; ++c) whole += scattering[c];
    Ray ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = mu_s;
    ray.nu = nu;
    ray.ground = hits_ground(altitude, mu);
    ray.end = real(0);
    TablePlace place = table_place(ray, textureSize(source_table, 0), 1);
    vec3 low = vec3(SAMPLE(source_table, place.at));
    vec3 high = vec3(SAMPLE(source_table, place.at + vec3(place.step, real(0), real(0))));
    return whole * mix(low, high, place.share);
}

#define AUREOLE_OWN_SCATTERED_DIFFUSE
#include "models/bruneton/bruneton_march.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec3 size = imageSize(scattering_out);
    int heights = size.z / scattering_layers();
    int z = first_slice() + id.z;
    if (id.x >= size.x || id.y >= size.y || z >= heights) return;
    Ray ray = table_ray(ivec3(id.x, id.y, z), ivec3(size.x, size.y, heights));
    RayLight light = no_light();
    if (PUBLISHED_STEPS) light = march_even(ray);
    else light = march(ray);

    vec3 first = light.multiple / rayleigh_phase(ray.nu);  // `multiple` has the table's scale already
    vec3 most = vec3(LARGEST_STORED);
    real sharp_red = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        vec3 single = TABLE_SCALE * light.single[c];
        if (!phase_is_sharp(c)) {
            first += single;
        } else if (COMBINED) {
            sharp_red = single.x;
        } else {
            imageStore(scattering_out, ivec3(id.x, id.y, z + sharp_layer(c) * heights), vec4(min(single, most), real(0)));
        }
    }
    imageStore(scattering_out, ivec3(id.x, id.y, z), vec4(min(first, most), sharp_red));
}
