// The functions that composite/composite.glsl asks of a model: from a camera in the air by its view table, from space by the 4D table.
#ifndef AUREOLE_BRUNETON_SKY_GLSL
#define AUREOLE_BRUNETON_SKY_GLSL

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SCATTERING_TABLE
#define AUREOLE_IRRADIANCE_TABLE
SAMPLER_3D(2, scattering_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, irradiance_table)
#define AUREOLE_VIEW_TABLE
SAMPLER_2D(11, view_table)
SAMPLER_2D(17, view_depth_table)

#define AUREOLE_PROFILE_TABLE 10

#include "common/view_ray.glsl"
#include "medium/medium.glsl"
#include "models/bruneton/bruneton_rays.glsl"
#include "models/bruneton/bruneton_view_table.glsl"

SPEC_BOOL(42, FROM_SPACE, false)  // ModelKernels::space_constant

vec3 sky_from_air(vec3 direction, ViewDirection v, vec3 beyond) {
    bool ground = sine_above_horizon(v) < 0;
    real position = mu_position(view.camera.x, v.mu, ground);
    vec3 radiance = vec3(real(0));
    int sun = 0;
    do {  // tested at the end: see march.glsl
        real nu = clamp(dot(direction, vec3(view.sun_direction[sun])), real(-1), real(1));
        radiance += vec3(view.sun_irradiance[sun]) * view_table_radiance(sun, position, ground, nu);
        ++sun;
    } while (sun < SUN_COUNT);
    if ((SUN_DISK || SCENE_COLOR) && !ground) radiance += beyond * view_table_transmittance(position);
    return radiance;
}

vec3 sky_from_space(vec3 direction, ViewDirection v, vec3 beyond) {
    real entry = distance_to_air(v);
    vec3 radiance = vec3(real(0));
    Ray ray;
    int sun = 0;
    do {  // tested at the end: see march.glsl
        ray = camera_air_ray(v, entry, sun, dot(direction, vec3(view.sun_direction[sun])));
        radiance += vec3(view.sun_irradiance[sun]) * ray_radiance(ray);
        ++sun;
    } while (sun < SUN_COUNT);
    if (entry < 0) return beyond;  // past the air
    if ((SUN_DISK || SCENE_COLOR) && !ray.ground) radiance += beyond * transmittance_to_top(ray.altitude, ray.mu);
    return radiance;
}

vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond) {
    if (FROM_SPACE) return sky_from_space(direction, v, beyond);
    return sky_from_air(direction, v, beyond);
}

// The rest of a ray behind a point on it.
Ray ray_behind(Ray ray, real t) {
    Ray on = ray;
    on.altitude = min(altitude_after(ray.altitude, ray.mu, t), shell_thickness());
    on.mu = view_mu_after(ray, t, on.altitude);
    on.mu_s = sun_mu_after(ray, t, on.altitude);
    on.end = ray.end - t;
    return on;
}

// The first stretch of the ray: long enough for its light to be more than what two look-ups are off by, and so short that it is lit
// evenly and thins by a known law, exp(-thinning t).
struct FirstStretch {
    real reach;     // km
    real thinning;  // 1/km; below 0 where the ray goes down
};
FirstStretch first_stretch(Ray ray) {
    vec2 air = extinction_and_decay(ray.altitude);
    FirstStretch first;
    first.thinning = air.y * ray.mu;
    first.reach = min(ray.end / 64, min(real(0.0625) / max(air.x, real(1e-20)), real(0.5) / max(abs(first.thinning), real(1e-20))));
    return first;
}

// Integral of exp(-thinning t') from 0 to t, its exponent at most 1/2: to 1 / 400.
real thinned_length(real thinning, real t) {
    real x = thinning * t;
    return t * (1 - x / 2 * (1 - x / 3));
}

// The difference of two look-ups: of the whole ray, and of what is left of it behind the point. It needs no place on the screen. Nearer
// than the first stretch it is that stretch's, by the share of its air: there the two would be nearly the same.
AerialPerspective aerial_perspective(real, real, real distance_km, vec3 direction) {
    ViewDirection v = view_direction(direction);
    real entry = distance_to_air(v);
    AerialPerspective result;
    result.transmittance = vec3(real(1));
    result.radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        Ray ray = camera_air_ray(v, entry, sun, dot(direction, vec3(view.sun_direction[sun])));
        real t = min(distance_km, ray.end);
        FirstStretch first = first_stretch(ray);
        real on_t = max(t, first.reach);
        real share = on_t > t ? thinned_length(first.thinning, t) / thinned_length(first.thinning, on_t) : real(1);
        vec3 depth = dark_depth(ray, real(0), on_t, !ray.ground);
        // (1 - exp(-share depth)) / (1 - exp(-depth)), to depth^2 / 12.
        vec3 of_it = share * (vec3(real(1)) + (real(0.5) * (1 - share)) * depth);
        result.transmittance = exp(-share * depth);
        result.radiance += of_it * vec3(view.sun_irradiance[sun]) *
                           air_radiance_before(scattering_place(ray), scattering_place(ray_behind(ray, on_t)), exp(-depth), ray.nu);
    }
    return result;
}

#endif
