// Look-ups for a host's own shaders: transparents, water, clouds, terrain, anything that the composite does not draw. The build
// makes one self-contained file of this one, <aureole/glsl/aureole.glsl>, installed beside the C++ headers. In it every global
// name begins with "aureole", and no other macro than AUREOLE_* is left behind it. How to use it: host.md.
//
//     #version 450
//     #define AUREOLE_SET 2                     // descriptor set of everything below (default 0)
//     #define AUREOLE_DEFINED_CONSTANTS
//     <the text of View::shader_defines()>      // what the kernels were specialized by
//     #include "aureole.glsl"
//
// Bind to the slots below: the uniform blocks View::air_block() and View::view_block(), the tables of Atmosphere and View with a
// linear, clamping sampler, and View::phase_table() with a nearest one. What a shader never calls needs no binding.
//
// Directions are unit vectors in the camera's world axes; offsets are metres from the camera, along the same axes. Radiance and
// irradiance come in the unit of Sun::irradiance (parameters.h), without the composite's exposure. Usable in any shader stage.
#ifndef AUREOLE_HOST_GLSL
#define AUREOLE_HOST_GLSL

// A host that wants other bindings defines all seven.
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

SPEC_BOOL(25, HAS_FROXELS, true)  // ViewSettings::aerial_perspective

#include "common/view_ray.glsl"
#include "transmittance/transmittance.glsl"
#include "sky_view/sky_view.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "light/harmonics.glsl"
#include "light/sun.glsl"

// Radiance of the sky (below the horizon: of the bare ground) that the camera sees in a direction, without the suns' disks.
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

// Share of light from beyond the air (stars, a moon) that reaches the camera from a direction; 0 below the horizon.
vec3 aureole_sky_transmittance(vec3 direction) {
    ViewDirection v = view_direction(direction);
    if (sine_above_horizon(v) < 0) return vec3(real(0));
    int sun = SUN_COUNT - 1;
    return sky_view_transmittance(
        sky_view_coordinates(sun, v.mu, v.sine, dot(v.horizontal, vec3(view.sun_azimuth[sun]))));
}

// What the air before a point does to the point's colour: color * transmittance + radiance.
struct AureoleAir {
    vec3 transmittance;
    vec3 radiance;
};

// (x, y): place on the target, in [0, 1]^2 from the first row's first corner; distance of the point from the camera along the
// direction of that place. Without ViewSettings::aerial_perspective: clear.
AureoleAir aureole_aerial_perspective(real x, real y, real distance_m, vec3 direction) {
    AureoleAir air;
    air.transmittance = vec3(real(1));
    air.radiance = vec3(real(0));
    if (!HAS_FROXELS) return air;
    real entry = distance_to_air(view_direction(direction));
    real distance_km = distance_m * real(0.001) - entry;
    if (entry < 0 || distance_km < 0) return air;
    AerialPerspective froxel = froxel_aerial_perspective(x, y, distance_km, direction);
    air.transmittance = froxel.transmittance;
    air.radiance = froxel.radiance;
    return air;
}

// Share of a sun's irradiance that reaches a point, any point outside the ground: inside the air or above it, and 0 in the planet's
// shadow. `sun`: its place in the list that View::update was given, below ViewSettings::max_suns.
vec3 aureole_sun_transmittance(int sun, vec3 offset_m) {
    vec3 offset = offset_m * real(0.001);
    vec3 place = (bottom_radius() + view.space.x) * vec3(view.up) + offset;  // from the planet's centre
    real t = sqrt(dot(offset, offset));
    real altitude = altitude_after(view.space.x, t > 0 ? dot(offset, vec3(view.up)) / t : real(1), t);
    vec3 up = place / max(sqrt(dot(place, place)), real(1e-6));
    vec3 towards = vec3(view.sun_direction[sun]);
    real mu_s = dot(up, towards);
    vec3 across = towards - mu_s * up;
    return sun_share(altitude, mu_s, sqrt(dot(across, across)), view.sun_limb[sun].w);
}

// Irradiance of a surface at a point that faces the sun; times max(dot(normal, direction to the sun), 0) for any other.
vec3 aureole_sun_irradiance(int sun, vec3 offset_m) {
    return vec3(view.sun_irradiance[sun]) * aureole_sun_transmittance(sun, offset_m);
}

// Irradiance that the sky (all suns' light, the ground's reflection from below) gives a surface of this normal at the camera.
// Needs ViewSettings::light.
vec3 aureole_sky_irradiance(vec3 normal) {
    vec3 irradiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun)
        for (int i = 0; i < HARMONIC_COUNT; ++i)
            irradiance += vec3(texelFetch(light_table, ivec2(i, sun), 0)) * harmonic_irradiance(i, normal);
    return max(irradiance, vec3(real(0)));
}

#endif
