// Look-ups for a host's own shaders: transparents, water, clouds, anything that the composite does not draw. The build makes one
// self-contained file of it, aureole.glsl, installed beside the C++ headers.
//
//     #version 450
//     #define AUREOLE_SET 2                     // descriptor set of everything below (default 0)
//     #define AUREOLE_DEFINED_CONSTANTS
//     <the text of View::shader_defines()>      // what the kernels were specialized by
//     #include "aureole.glsl"
//
// Bind to the slots below: the uniform blocks View::air_block() and View::view_block(), the tables of Atmosphere and View with a
// linear, clamping sampler, and View::phase_table() with a nearest one. Directions are unit vectors in the camera's world axes;
// offsets are metres from the camera. Radiance and irradiance come in the unit of Sun::irradiance (parameters.h).
#ifndef AUREOLE_HOST_GLSL
#define AUREOLE_HOST_GLSL

#ifndef AUREOLE_SLOT_AIR
#define AUREOLE_SLOT_AIR 0
#define AUREOLE_SLOT_VIEW 1
#define AUREOLE_SLOT_SKY_VIEW 2
#define AUREOLE_SLOT_TRANSMITTANCE 3
#define AUREOLE_SLOT_AERIAL_PERSPECTIVE 4
#define AUREOLE_SLOT_LIGHT 5
#define AUREOLE_SLOT_PHASES 6
#endif

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE AUREOLE_SLOT_PHASES
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_AERIAL_PERSPECTIVE_TABLE
UNIFORMS(AUREOLE_SLOT_AIR, AtmosphereBlock, atm)
UNIFORMS(AUREOLE_SLOT_VIEW, ViewBlock, view)
SAMPLER_2D(AUREOLE_SLOT_SKY_VIEW, sky_view_table)
SAMPLER_2D(AUREOLE_SLOT_TRANSMITTANCE, transmittance_table)
SAMPLER_3D(AUREOLE_SLOT_AERIAL_PERSPECTIVE, aerial_perspective_table)
SAMPLER_2D(AUREOLE_SLOT_LIGHT, light_table)

#include "common/view_ray.glsl"
#include "transmittance/transmittance.glsl"
#include "sky_view/sky_view.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "light/harmonics.glsl"

// Radiance of the sky (and of the bare ground) in a direction, without the suns' disks.
vec3 aureole_sky(vec3 direction) {
    ViewDirection v = view_direction(direction);
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        vec3 coordinates = sky_view_coordinates(sun, v.mu, v.sine, dot(v.horizontal, vec3(view.sun_azimuth[sun])));
        radiance += vec3(view.sun_irradiance[sun]) *
                    sky_view_radiance(coordinates, dot(direction, vec3(view.sun_direction[sun])));
    }
    return radiance;
}

// What the air before a point does to it: color * transmittance + radiance. (x, y) of the target in [0, 1]^2, the point's distance
// from the camera in metres, its direction.
AerialPerspective aureole_aerial_perspective(real x, real y, real distance_m, vec3 direction) {
    real entry = distance_to_air(view_direction(direction));
    AerialPerspective clear;
    clear.transmittance = vec3(real(1));
    clear.radiance = vec3(real(0));
    real distance_km = distance_m * real(0.001) - entry;
    if (entry < 0 || distance_km < 0) return clear;
    return aerial_perspective(x, y, distance_km, direction);
}

// Irradiance of a surface that faces the sun at a point, `offset_m` from the camera; 0 behind the horizon. The altitude comes
// from r'^2 - R^2 = h (2 R + h) + 2 r (offset . up) + |offset|^2, without squares of the radius.
vec3 aureole_sun_irradiance(int sun, vec3 offset_m) {
    vec3 offset = offset_m * real(0.001);
    real radius = bottom_radius();
    real h = view.space.x;
    real gain = 2 * (radius + h) * dot(offset, vec3(view.up)) + dot(offset, offset);
    real r = sqrt(max((radius + h) * (radius + h) + gain, real(0)));
    real altitude = max((h * (2 * radius + h) + gain) / (r + radius), real(0));
    real mu_s = clamp(((radius + h) * view.sun_direction[sun].w + dot(offset, vec3(view.sun_direction[sun]))) / max(r, radius),
                      real(-1), real(1));
    vec3 irradiance = vec3(view.sun_irradiance[sun]);
    // Above the air nothing but the ground is in the way.
    if (altitude >= shell_thickness()) return hits_ground(altitude, mu_s) ? vec3(real(0)) : irradiance;
    return irradiance * transmittance_to_sun(altitude, mu_s);
}

// Irradiance that the sky (all suns' light, the ground's reflection from below) gives a surface of this normal at the camera.
vec3 aureole_sky_irradiance(vec3 normal) {
    vec3 irradiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun)
        for (int i = 0; i < 9; ++i)
            irradiance += vec3(texelFetch(light_table, ivec2(i, sun), 0)) * (cosine_lobe(i) * world_harmonic(i, normal));
    return max(irradiance, vec3(real(0)));
}

#endif
