// Scattering density: what the air at a point scatters of the field around it into the ray of each texel,
//   J = integral over the sphere of sum_c sigma_c p_c(angle) L,
// stored per unit of scattering (J / sum_c sigma_c), which varies far less with altitude than J and interpolates better.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, zenith_quadrature)
SAMPLER_3D(4, arriving_table)
IMAGE_3D(6, source_out)

#include "medium/medium.glsl"
#include "models/bruneton/bruneton.glsl"
#include "models/bruneton/bruneton_directions.glsl"
#include "models/bruneton/slices.glsl"
#include "phase/smooth_phase.glsl"

LOCAL_SIZE(64, 1, 1)

real phase_of(int c, real nu) {
    if (!phase_is_sharp(c)) return rayleigh_phase(nu);
    return PUBLISHED_STEPS ? phase_value(c, clamp(nu, real(-1), real(1))) : smooth_phase(c, nu);
}

COMPUTE_MAIN(id) {
    ivec3 size = imageSize(source_out);
    int z = first_slice() + id.z;
    if (id.x >= size.x || id.y >= size.y || z >= size.z) return;
    int sun = id.x % (size.x / NU_NODES);
    Ray ray = table_ray(ivec3(id.x, id.y, z), size);
    // The ray's direction: up, towards the sun's azimuth, aside. With the sun at the zenith the field has no azimuth.
    real sine_squared = max((1 - ray.mu) * (1 + ray.mu), real(0));
    real limit = sqrt(sine_squared);
    real sun_sine = sqrt(max((1 - ray.mu_s) * (1 + ray.mu_s), real(1e-8)));
    real towards = clamp((ray.nu - ray.mu * ray.mu_s) / sun_sine, -limit, limit);
    real aside = sqrt(max(sine_squared - towards * towards, real(0)));

    vec3 scattered[MAX_PHASES];
    for (int c = 0; c < PHASE_COUNT; ++c) scattered[c] = vec3(real(0));
    real turn_cosine = cos(PI / real(AZIMUTH_NODES));
    real turn_sine = sin(PI / real(AZIMUTH_NODES));
    real first_cosine = cos(real(0.5) * PI / real(AZIMUTH_NODES));
    real first_sine = sin(real(0.5) * PI / real(AZIMUTH_NODES));
    int q = 0;
    do {  // tested at the end: see march.glsl
        real mu = arriving_direction(q, ray.altitude).mu;
        real sine = sqrt(max((1 - mu) * (1 + mu), real(0)));
        real along = mu * ray.mu;
        real azimuth_cosine = first_cosine;
        real azimuth_sine = first_sine;
        int k = 0;
        do {
            // The direction and its mirror image at the other side of the sun's vertical plane, from which as much arrives.
            vec3 light = real(0.5) * vec3(texelFetch(arriving_table, ivec3(sun, q, z), 0));
            real common_part = along + sine * towards * azimuth_cosine;
            real mirrored_part = sine * aside * azimuth_sine;
            for (int c = 0; c < PHASE_COUNT; ++c)
                scattered[c] += (phase_of(c, common_part + mirrored_part) + phase_of(c, common_part - mirrored_part)) * light;
            real turned = azimuth_cosine * turn_cosine - azimuth_sine * turn_sine;
            azimuth_sine = azimuth_sine * turn_cosine + azimuth_cosine * turn_sine;
            azimuth_cosine = turned;
            ++k;
            ++q;
        } while (k < AZIMUTH_NODES);
    } while (q < direction_count());

    Medium air = sample_medium(ray.altitude);
    vec3 sum = vec3(real(0));
    vec3 whole = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) {
        sum += air.scattering[c] * scattered[c];
        whole += air.scattering[c];
    }
    vec3 source = TABLE_SCALE * max(sum, vec3(real(0))) / max(whole, vec3(real(1e-30)));
    imageStore(source_out, ivec3(id.x, id.y, z), vec4(min(source, vec3(LARGEST_STORED)), real(0)));
}
