// From a point of the target to a direction, and from the depth buffer to a distance. Needs `view` (ViewBlock, blocks.glsl).
#ifndef AUREOLE_VIEW_RAY_GLSL
#define AUREOLE_VIEW_RAY_GLSL

#include "common/constants.glsl"
#include "common/geometry.glsl"
#include "common/horizon.glsl"

SPEC_INT(24, RAY_KIND, 0)  // 0 matrix, 1 panorama, 2 fisheye: as aureole::Projection

struct ViewRay {
    vec3 direction;  // unit, world axes
    real stretch;    // distance along it per unit of view depth
    bool valid;      // false outside a fisheye's circle
};

// (x, y) in [0, 1]^2 of the target.
ViewRay view_ray(real x, real y) {
    ViewRay ray;
    ray.stretch = real(1);
    ray.valid = true;
    vec3 a = vec3(view.ray_origin);
    vec3 b = vec3(view.ray_x);
    vec3 c = vec3(view.ray_y);
    if (RAY_KIND == 0) {
        vec3 d = a + x * b + y * c;
        ray.stretch = sqrt(dot(d, d));
        ray.direction = d / ray.stretch;
    } else if (RAY_KIND == 1) {
        real azimuth = (2 * x - 1) * PI;
        real elevation = (real(0.5) - y) * PI;
        ray.direction = cos(elevation) * (cos(azimuth) * a + sin(azimuth) * b) + sin(elevation) * c;
    } else {
        real p = 2 * x - 1;
        real q = 1 - 2 * y;
        real radius = sqrt(p * p + q * q);
        real zenith = min(radius, real(1)) * real(0.5) * PI;
        real scale = sin(zenith) / max(radius, real(1e-6));
        ray.direction = scale * (p * b + q * a) + cos(zenith) * c;
        ray.valid = radius <= 1;
    }
    return ray;
}

// A direction as seen from the camera: its parts along and across the vertical, both exact near the zenith and the horizon. Directions
// are floats: within 1e-7 of the vertical there is no azimuth, and what it stands for is off by no more than that sine.
struct ViewDirection {
    real mu;
    real sine;       // of the zenith angle
    vec3 horizontal; // unit (any horizontal vector at the zenith)
};
ViewDirection view_direction(vec3 direction) {
    ViewDirection v;
    vec3 up = vec3(view.up);
    v.mu = dot(direction, up);
    vec3 across = direction - v.mu * up;
    v.sine = sqrt(dot(across, across));
    v.horizontal = v.sine > real(1e-7) ? across / v.sine : vec3(view.east);
    return v;
}

real sine_above_horizon(ViewDirection v) { return sine_above_horizon(v.mu, v.sine); }

// Altitude of the lowest point of a direction's line, from its angle to the horizon (sky_view/camera_ray.glsl): the difference of
// r sin and R would be off by a step of r, which is a large part of a thin shell.
real lowest_altitude(ViewDirection v) {
    real half_sine = min(real(0.5) * chord_to_horizon(v.mu, v.sine), real(1));
    real q = sine_above_horizon(v) < 0 ? -half_sine : half_sine;
    real half_cosine = sqrt(max(1 - q * q, real(0)));
    return 2 * (bottom_radius() + view.space.x) * (view.horizon.y * half_cosine - view.horizon.x * q) * q;
}

// Distance at which a camera above the air enters it, 0 inside it, -1 if the ray misses it. The smaller root of
// t^2 + 2 r mu t + r^2 - T^2 = 0 by the product of both: -r mu less half the chord would be off by a step of r.
real distance_to_air(ViewDirection v) {
    if (view.camera.w < real(0.5)) return real(0);
    real r = bottom_radius() + view.space.x;
    real lowest = lowest_altitude(v);
    if (v.mu >= 0 || lowest > shell_thickness()) return real(-1);
    return squares_apart(shell_thickness(), view.space.x) / max(half_chord(lowest) - r * v.mu, real(1e-20));
}

// Ray in the air for a direction, from where it starts there; its end is for the caller to set. `nu` of two rounded directions may
// lie beyond 1, which would move the sun by as much of the way to the air.
Ray air_ray(ViewDirection v, real entry, int sun, real nu) {
    Ray ray;
    real r = bottom_radius() + view.space.x;
    real top = bottom_radius() + shell_thickness();
    bool space = view.camera.w > real(0.5);
    nu = clamp(nu, real(-1), real(1));
    ray.altitude = view.camera.x;
    ray.mu = v.mu;
    if (space) ray.mu = entry > 0 ? -half_chord(lowest_altitude(v)) / top : clamp(r * v.mu / top, real(-1), real(1));
    ray.nu = nu;
    ray.mu_s = space ? clamp((r * view.sun_direction[sun].w + entry * nu) / top, real(-1), real(1)) : view.sun_direction[sun].w;
    ray.ground = false;
    ray.end = real(0);
    return ray;
}

// The camera's ray through the air, from where it enters it (distance_to_air) to the ground or the top; without length where it
// misses it.
Ray camera_air_ray(ViewDirection v, real entry, int sun, real nu) {
    Ray ray = air_ray(v, max(entry, real(0)), sun, nu);
    ray.ground = sine_above_horizon(v) < 0;
    ray.end = ray.ground ? distance_to_ground_over(ray.altitude, ray.mu, lowest_altitude(v)) : distance_to_top(ray.altitude, ray.mu);
    if (entry < 0) ray.end = real(0);
    return ray;
}

#endif
