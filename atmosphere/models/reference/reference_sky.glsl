// The functions that composite/composite.glsl asks of a model, by path tracing.
#ifndef AUREOLE_REFERENCE_SKY_GLSL
#define AUREOLE_REFERENCE_SKY_GLSL

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_SKY_RADIANCE(pixel, direction, v, beyond) traced_sky(pixel, direction, v, beyond)
UNIFORMS(11, QuadratureBlock, quadrature)
SPEC_BOOL(32, FILM, false)
SPEC_BOOL(33, SHOW_ERROR, false)  // the standard error in place of the radiance

#include "models/reference/film.glsl"

vec3 shown(vec3 exact, Estimate estimate) { return SHOW_ERROR ? standard_error(estimate) : exact + estimate.mean; }

// From the film: the texel of the pixel's point, or between four of them where target and film differ in size.
vec3 film_shown(ivec2 texel) { return shown(vec3(film_texel(texel, 2)), film_estimate(texel)); }
vec3 film_sky(ivec2 pixel) {
    ivec2 size = film_size();
    real x = (real(pixel.x) + real(0.5)) / target.size.x * real(size.x) - real(0.5);
    real y = (real(pixel.y) + real(0.5)) / target.size.y * real(size.y) - real(0.5);
    int i = int(floor(x + real(1e-3)));
    int j = int(floor(y + real(1e-3)));
    real u = max(x - real(i), real(0));
    real v = max(y - real(j), real(0));
    if (u < real(2e-3) && v < real(2e-3)) return film_shown(ivec2(i, j));
    return mix(mix(film_shown(ivec2(i, j)), film_shown(ivec2(i + 1, j)), u), mix(film_shown(ivec2(i, j + 1)), film_shown(ivec2(i + 1, j + 1)), u), v);
}

// Paths come last wherever they are traced: a driver that ends the loops of an invocation which has done too much (reference.md) then
// cuts their number, not what is known without them.
vec3 traced(ivec2 pixel, Walk walk, Leg leg) {
    vec3 exact = SHOW_ERROR ? vec3(real(0)) : exact_part(walk, leg, ALL_SUNS);
    Estimate estimate = no_estimate();
    add_paths(estimate, walk, leg, ALL_SUNS, uint(pixel.x), uint(pixel.y), int(target.size.z) * PATHS, PATHS);
    return shown(exact, estimate);
}

vec3 traced_sky(ivec2 pixel, vec3 direction, ViewDirection v, vec3 beyond) {
    CameraWalk start = camera_walk(direction, v);
    if (!start.met) return SHOW_ERROR ? vec3(real(0)) : whole(beyond);
    Leg leg = leg_to_end(start.walk, FIRST_ORDER_SAMPLED, ALL_SUNS);
    vec3 behind = vec3(real(0));
    if ((SUN_DISK || SCENE_COLOR) && !SHOW_ERROR && !leg.ground)
        behind = beyond * in_rgb(exp(-optical_depth_along(start.walk.altitude, start.walk.mu, leg.end)));
    if (FILM && !GIVEN_DIRECTIONS) return film_sky(pixel) + behind;
    return traced(pixel, start.walk, leg) + behind;
}

AerialPerspective aerial_perspective(real x, real y, real distance_km, vec3 direction) {
    CameraWalk start = camera_walk(direction, view_direction(direction));
    real end = min(distance_km, distance_to_top(start.walk.altitude, start.walk.mu));
    AerialPerspective result;
    result.transmittance = SHOW_ERROR ? vec3(real(0)) : in_rgb(exp(-optical_depth_along(start.walk.altitude, start.walk.mu, end)));
    result.radiance = traced(ivec2(int(x * target.size.x), int(y * target.size.y)), start.walk,
                             make_leg(start.walk, end, false, FIRST_ORDER_SAMPLED, ALL_SUNS));
    return result;
}

#endif
