// Light for the host's own materials: SH-L2 of the sky as the camera's position sees it, and the sun's irradiance there.
// One invocation a texel of the light table: column 0..8 the coefficient in world axes, real basis, order 00, 1-1, 10, 11, 2-2, ..,
// 22 (y, z, x; xy, yz, z^2, xz, x^2 - y^2); column 9 the sun. Row: sun. Ramamoorthi & Hanrahan 2001 turn the coefficients into
// the irradiance of a surface (see aureole.glsl). Radiance from below the horizon, reflected by the ground, is part of it.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SKY_VIEW_TABLE
// Aerosols' phases without their peak, which the few directions of the integral would miss or exaggerate.
#define AUREOLE_SHARP_PHASE(c, nu) smooth_phase(c, nu)
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
SAMPLER_2D(2, sky_view_table)
SAMPLER_2D(3, transmittance_table)
UNIFORMS(4, QuadratureBlock, zenith_quadrature)
IMAGE_2D(5, light_out)

#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"
#include "phase/smooth_phase.glsl"
#include "sky_view/sky_view.glsl"
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
                vec3 coordinates = sky_view_coordinates(sun, sin(elevation), cos(elevation), cos(azimuth));
                sum += sky_view_radiance(coordinates, nu) * (weight * world_harmonic(coefficient, direction));
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
