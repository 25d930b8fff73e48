// Light for the host's own materials: SH-L2 of the sky as the camera's position sees it, and the sun's irradiance there.
// One invocation a texel of the light table: column 0..8 the coefficient in world axes, real basis, order 00, 1-1, 10, 11, 2-2, ..,
// 22 (y, z, x; xy, yz, z^2, xz, x^2 - y^2); column 9 the sun. Row: sun. Ramamoorthi & Hanrahan 2001 turn the coefficients into
// the irradiance of a surface (see aureole.glsl). Radiance from below the horizon, reflected by the ground, is part of it.
//
// The including kernel has included light/inputs.glsl and the model's own functions:
//   vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real nu): what the camera sees of the air and the bare
//     ground, per unit of the sun's irradiance, aerosols by smooth_phase: without their peak, which the few directions of the
//     integral would miss or exaggerate;
//   vec3 transmittance_to_top(real altitude, real mu), as transmittance.glsl has it.
#ifndef AUREOLE_LIGHT_GLSL
#define AUREOLE_LIGHT_GLSL

#include "light/harmonics.glsl"
#include "light/sun.glsl"

CONST(int, LIGHT_ZENITHS, 8)
CONST(int, LIGHT_AZIMUTHS, 12)

LOCAL_SIZE(10, 1, 1)

vec3 sky_coefficient(int sun, int coefficient) {
    vec3 up = vec3(view.up);
    vec3 towards = vec3(view.sun_azimuth[sun]);
    vec3 side = cross(up, towards);
    vec3 sum = vec3(real(0));
    for (int half_sphere = 0; half_sphere < 2; ++half_sphere) {
        bool below = half_sphere == 1;
        real range = below ? real(0.5) * PI - view.space.z : view.space.z - view.space.y;  // from the horizon to the last of the sky
        for (int i = 0; i < LIGHT_ZENITHS; ++i) {
            real s = zenith_quadrature.node[i].x;
            real angle = range * s * s;
            real elevation = (below ? -angle : angle) - view.space.z;
            real weight = zenith_quadrature.node[i].y * range * 2 * s * cos(elevation) * (2 * PI / real(LIGHT_AZIMUTHS));
            for (int k = 0; k < LIGHT_AZIMUTHS; ++k) {
                real azimuth = 2 * PI * (real(k) + real(0.5)) / real(LIGHT_AZIMUTHS);
                vec3 direction = cos(elevation) * (cos(azimuth) * towards + sin(azimuth) * side) + sin(elevation) * up;
                real nu = dot(direction, vec3(view.sun_direction[sun]));
                sum += smooth_sky_radiance(sun, sin(elevation), cos(elevation), cos(azimuth), nu) *
                       (weight * world_harmonic(coefficient, direction));
            }
        }
    }
    return sum;
}

// Irradiance of a surface that faces the sun, per unit of the sun's.
vec3 sun_at_camera(int sun) {
    return sun_share(view.space.x, view.sun_direction[sun].w, view.sun_azimuth[sun].w, view.sun_limb[sun].w);
}

COMPUTE_MAIN(id) {
    int sun = id.y;
    if (id.x > HARMONIC_COUNT || sun >= SUN_COUNT) return;
    vec3 value = id.x < HARMONIC_COUNT ? sky_coefficient(sun, id.x) : sun_at_camera(sun);
    imageStore(light_out, ivec2(id.x, sun), vec4(value * vec3(view.sun_irradiance[sun]), real(1)));
}

#endif
