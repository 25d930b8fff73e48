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
// linear, clamping sampler, View::phase_table() and profile_table() with a nearest one. What a shader never calls needs no binding.
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
// And this one, if it marches (AUREOLE_SUN_VISIBILITY below).
#ifndef AUREOLE_SLOT_PROFILES
#define AUREOLE_SLOT_PROFILES 7
#endif

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE AUREOLE_SLOT_PHASES
#define AUREOLE_PROFILE_TABLE AUREOLE_SLOT_PROFILES
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
#ifdef AUREOLE_SUN_VISIBILITY
#include "shadows/beam.glsl"
#endif

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

// Shadows of the host's own making. A host that says, before the include,
//     #define AUREOLE_SUN_VISIBILITY(offset_m) <share of the sun's beam that gets there, in [0, 1]: float or vec3>
// gets a march along a ray that asks it for every sample: its shadow maps, its clouds, its ray tracing.
#ifdef AUREOLE_SUN_VISIBILITY
struct AureoleBeam {
    vec3 transmittance;  // of the air of the segment
    vec3 radiance;       // what it scatters towards the camera of the sun's direct beam, where AUREOLE_SUN_VISIBILITY lets that through
    vec3 loss;           // what it would scatter besides, were nothing in shadow
};

// The segment from begin_m to end_m of a ray of the camera, of which the part in the air counts, before the ground. As from its
// beginning, so that segments put behind one another are one: radiance += transmittance * next.radiance, transmittance *= next.transmittance.
// Evenly cut into `samples` (>= 1) slabs, each sampled at `jitter` of its length, in [0, 1): 0.5, or noise of the pixel and frame.
AureoleBeam aureole_march(int sun, vec3 direction, real begin_m, real end_m, int samples, real jitter) {
    ViewDirection v = view_direction(direction);
    real entry = distance_to_air(v);
    real before = max(entry, real(0));
    Ray ray = camera_air_ray(v, entry, sun, dot(direction, vec3(view.sun_direction[sun])));
    real begin = clamp(begin_m * real(0.001) - before, real(0), ray.end);
    real step_km = (clamp(end_m * real(0.001) - before, begin, ray.end) - begin) / real(samples);
    AureoleBeam result;
    result.radiance = vec3(real(0));
    result.loss = vec3(real(0));
    vec3 depth = vec3(real(0));
    for (int k = 0; k < samples; ++k) {  // each pixel may have a number of its own, therefore two exits: see common/march.glsl
        real t = begin + (real(k) + jitter) * step_km;
        BeamSlab slab = beam_slab(ray, depth, t, step_km);
        vec3 scattered = vec3(real(0));
        for (int c = 0; c < PHASE_COUNT; ++c) scattered += slab.air.scattering[c] * phase_value(c, ray.nu);
        scattered *= slab.beam * vec3(view.sun_irradiance[sun]);
        vec3 lit = vec3(AUREOLE_SUN_VISIBILITY((direction * ((before + t) * real(1000)))));
        result.radiance += lit * scattered;
        result.loss += (vec3(real(1)) - lit) * scattered;
        depth += slab.depth;
        if (k + 1 >= samples) break;
    }
    result.transmittance = exp(-depth);
    return result;
}
#endif

#endif
