// The functions that composite/composite.glsl asks of a model, by single scattering: marched for each pixel, or the sky taken from
// the dome.
#ifndef AUREOLE_SINGLE_SKY_GLSL
#define AUREOLE_SINGLE_SKY_GLSL

#define AUREOLE_SKY_VIEW_TABLE
SAMPLER_2D(2, sky_view_table)
SPEC_BOOL(33, DOME, false)

#include "models/single/single.glsl"
#include "sky_view/sky_view.glsl"

vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond) {
    vec3 radiance = vec3(real(0));
    vec3 through;  // the air of all rays is the same, whichever the sun
    int sun = 0;
    do {  // tested at the end: see march.glsl
        real azimuth_cosine = dot(v.horizontal, vec3(view.sun_azimuth[sun]));
        real nu = dot(direction, vec3(view.sun_direction[sun]));
        vec3 seen;
        if (DOME) {
            vec3 coordinates = sky_view_coordinates(sun, v.mu, v.sine, azimuth_cosine);
            seen = sky_view_radiance(coordinates, nu);
            through = sky_view_transmittance(coordinates);
        } else {
            Ray ray = camera_ray_towards(v.mu, v.sine, azimuth_cosine, sun);
            RayLight light = march_single(ray);
            seen = scattered_once(light, nu) + ground_once(ray, light);
            through = exp(-light.depth);
        }
        radiance += sunlit(sun, seen);
        ++sun;
    } while (sun < SUN_COUNT);
    if ((SUN_DISK || SCENE_COLOR) && sine_above_horizon(v) >= 0) radiance += beyond * in_rgb(through);
    return radiance;
}

AerialPerspective aerial_perspective(real /*x*/, real /*y*/, real distance_km, vec3 direction) {
    ViewDirection v = view_direction(direction);
    real entry = max(distance_to_air(v), real(0));
    AerialPerspective result;
    result.radiance = vec3(real(0));
    int sun = 0;
    do {
        real nu = dot(direction, vec3(view.sun_direction[sun]));
        Ray ray = air_ray(v, entry, sun, nu);
        ray.end = min(distance_km, distance_to_top(ray.altitude, ray.mu));
        RayLight light = march_single(ray);
        result.radiance += sunlit(sun, scattered_once(light, nu));
        result.transmittance = in_rgb(exp(-light.depth));
        ++sun;
    } while (sun < SUN_COUNT);
    return result;
}

#endif
