// The functions that composite/composite.glsl asks of a model: each by a table, or by a march for each pixel.
#ifndef AUREOLE_HILLAIRE_SKY_LIGHT_GLSL
#define AUREOLE_HILLAIRE_SKY_LIGHT_GLSL

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_AERIAL_PERSPECTIVE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
SAMPLER_2D(2, sky_view_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_3D(4, aerial_perspective_table)
SAMPLER_2D(11, multi_scatter_table)
SPEC_INT(8, RAY_STEPS, 30)
SPEC_BOOL(26, FAST_SKY, true)                 // by the sky-view table
SPEC_BOOL(27, FAST_AERIAL_PERSPECTIVE, true)  // by the froxels

#include "models/hillaire/hillaire.glsl"
#include "sky_view/sky_view.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "common/ground.glsl"
#include "sky_view/camera_ray.glsl"

// All light of a marched ray, its phase functions applied.
vec3 gathered(Ray ray, RayLight light) {
    vec3 radiance = light.multiple;
    for (int c = 0; c < PHASE_COUNT; ++c) radiance += light.single[c] * phase_value(c, ray.nu);
    return radiance;
}

vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond) {
    bool below = sine_above_horizon(v) < 0;
    real chord = chord_to_horizon(v.mu, v.sine);
    // A camera in space that looks past the air.
    bool past = view.camera.w > real(0.5) && !below && chord * view.horizon.z > 1;
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        real azimuth_cosine = dot(v.horizontal, vec3(view.sun_azimuth[sun]));
        if (FAST_SKY) {
            vec3 coordinates = sky_view_coordinates(sun, v.mu, v.sine, azimuth_cosine);
            radiance += sunlit(sun, sky_view_radiance(coordinates, dot(direction, vec3(view.sun_direction[sun]))));
        } else if (!past) {
            Ray ray = camera_ray(min(real(0.5) * chord, real(1)), below, azimuth_cosine, sun);
            RayLight light = march_steps(ray, RAY_STEPS, true);
            vec3 marched = gathered(ray, light);
            if (below) marched += ground_radiance(light.depth, ground_beam_irradiance(sun_mu_after(ray, ray.end, real(0))));
            radiance += sunlit(sun, marched);
        }
    }
    if ((SUN_DISK || SCENE_COLOR) && !below) {
        Ray ray = camera_ray(min(real(0.5) * chord, real(1)), below, real(1), 0);
        radiance += past ? whole(beyond) : beyond * in_rgb(transmittance_to_top(ray.altitude, ray.mu));
    }
    return radiance;
}

AerialPerspective aerial_perspective(real x, real y, real distance_km, vec3 direction) {
    if (FAST_AERIAL_PERSPECTIVE) return froxel_aerial_perspective(x, y, distance_km, direction);
    ViewDirection v = view_direction(direction);
    real entry = max(distance_to_air(v), real(0));
    AerialPerspective result;
    result.transmittance = in_rgb(vec3(real(1)));
    result.radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        Ray ray = air_ray(v, entry, sun, dot(direction, vec3(view.sun_direction[sun])));
        ray.end = min(distance_km, distance_to_top(ray.altitude, ray.mu));
        RayLight light = march_steps(ray, RAY_STEPS, true);
        result.radiance += sunlit(sun, gathered(ray, light));
        result.transmittance = in_rgb(transmittance_shown(light.depth));
    }
    return result;
}

#endif
