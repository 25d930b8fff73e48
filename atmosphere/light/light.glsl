// Light for the host's own materials: SH-L2 of the sky as the camera's position sees it, and the sun's irradiance there.
// One invocation a texel of the light table: column 0..8 the coefficient in world axes, real basis, order 00, 1-1, 10, 11, 2-2, ..,
// 22 (y, z, x; xy, yz, z^2, xz, x^2 - y^2); column 9 the sun. Row: sun. Ramamoorthi & Hanrahan 2001 turn the coefficients into
// the irradiance of a surface (see aureole.glsl). Radiance from below the horizon, reflected by the ground, is part of it.
//
// The including kernel has included light/inputs.glsl and the model's own functions:
//   vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real nu): what the camera sees of the air and the bare
//     ground, per unit of the sun's irradiance, in RGB (in_rgb of triplet.glsl, unless all comes from tables), aerosols by smooth_phase: without their peak, which the few directions of the
//     integral would miss or exaggerate;
//   vec3 transmittance_to_top(real altitude, real mu), as transmittance.glsl has it.
// A model that has traced the directions of the integral (directions.glsl) beforehand gives, instead of the first, an
// AUREOLE_LIGHT_RADIANCE(sun, index, at) that looks the radiance of the direction of this index up.
#ifndef AUREOLE_LIGHT_GLSL
#define AUREOLE_LIGHT_GLSL

#include "common/energy.glsl"
#include "light/directions.glsl"
#include "light/harmonics.glsl"
#include "light/sun.glsl"

SAMPLER_2D(14, sum_before)  // of the triplets before (triplet.glsl)

#ifndef AUREOLE_LIGHT_RADIANCE
#define AUREOLE_LIGHT_RADIANCE(sun, index, at) smooth_sky_radiance(sun, at.mu, at.sine, at.azimuth_cosine, at.nu)
#endif

LOCAL_SIZE(10, 1, 1)

// However sharp a peak that the rule's directions meet or miss, from where a ring stands for comes no more than the sun's own beam and
// what is diffuse: of what each run gathers, of three wavelengths in RGB.
vec3 sky_coefficient(int sun, int coefficient) {
    vec3 sum = vec3(real(0));
    for (int ring = 0; ring < LIGHT_RINGS; ++ring) {
        LightRing around = light_ring(ring);
        vec3 share = vec3(real(0));
        vec3 all = vec3(real(0));
        for (int k = 0; k < LIGHT_AZIMUTHS; ++k) {
            LightDirection at = light_direction(sun, around, k);
            vec3 light = AUREOLE_LIGHT_RADIANCE(sun, ring * LIGHT_AZIMUTHS + k, at) * around.weight;
            share += light * world_harmonic(coefficient, at.direction);
            all += light;
        }
        real most = 1 + MOST_MEAN_RADIANCE * around.weight * real(LIGHT_AZIMUTHS);
        sum += share * (most / max(all, vec3(most)));
    }
    return sum;
}

// Irradiance of a surface that faces the sun, per unit of the sun's.
vec3 sun_at_camera(int sun) {
    return in_rgb(sun_share(view.space.x, view.sun_direction[sun].w, view.sun_azimuth[sun].w, view.sun_limb[sun].w));
}

COMPUTE_MAIN(id) {
    int sun = id.y;
    if (id.x > HARMONIC_COUNT || sun >= SUN_COUNT) return;
    vec3 value = id.x < HARMONIC_COUNT ? sky_coefficient(sun, id.x) : sun_at_camera(sun);
    vec3 lit = value * vec3(view.sun_irradiance[sun]);
    if (!first_triplet()) lit += vec3(texelFetch(sum_before, ivec2(id.x, sun), 0));
    imageStore(light_out, ivec2(id.x, sun), vec4(lit, real(1)));
}

#endif
