// Rays of the camera's sky. Needs `atm`, `view`, geometry.glsl.
#ifndef AUREOLE_CAMERA_RAY_GLSL
#define AUREOLE_CAMERA_RAY_GLSL

#include "common/geometry.glsl"
#include "common/horizon.glsl"

// A ray of the camera, at the angle a above or below the horizon, moved to where it enters the shell if the camera is above it.
// Given is sin(a / 2) >= 0: with it and the dip's cosine and sine no trigonometric function is needed, whose inverses devices
// compute to four digits only. The horizon belongs to both sides: above it its ray goes on to the top, below it it ends on the
// ground.
//
// With e = a - d the elevation of the ray, d the dip of the horizon (r cos d = R), a < 0 below, the tangent point's altitude
// p - R is r cos(e) - R = r (cos(d - a) - cos d) = 2 r sin(d - a / 2) sin(a / 2): no cancellation, so the limb is exact from any
// distance. On the shell's top mu^2 = 1 - (p / T)^2 = (T - p) (T + p) / T^2. The ground is met sqrt(R^2 - p^2) before the tangent
// point.
Ray camera_ray(real half_sine, bool below, real azimuth_cosine, int sun) {
    bool space = view.camera.w > real(0.5);
    real radius = bottom_radius();
    real r = radius + view.space.x;
    real dip_cosine = view.horizon.x;
    real dip_sine = view.horizon.y;
    real q = below ? -half_sine : half_sine;
    real half_cosine = sqrt(max(1 - q * q, real(0)));
    real angle_sine = 2 * q * half_cosine;
    real angle_cosine = 1 - 2 * q * q;
    real mu = clamp(angle_sine * dip_cosine - angle_cosine * dip_sine, real(-1), real(1));
    real sine = max(angle_cosine * dip_cosine + angle_sine * dip_sine, real(0));
    real lowest = 2 * r * (dip_sine * half_cosine - dip_cosine * q) * q;
    real to_lowest = -r * mu;

    Ray ray;
    ray.ground = below;
    ray.altitude = view.camera.x;
    ray.mu = mu;
    ray.mu_s = view.sun_direction[sun].w;
    ray.nu = clamp(mu * ray.mu_s + sine * view.sun_azimuth[sun].w * azimuth_cosine, real(-1), real(1));
    if (space) {
        real top = radius + shell_thickness();
        real chord = half_chord(lowest);
        real t = max(to_lowest - chord, real(0));
        to_lowest = chord;
        ray.altitude = shell_thickness();
        ray.mu = -chord / top;
        ray.mu_s = clamp((r * ray.mu_s + t * ray.nu) / top, real(-1), real(1));
    }
    real tangent = horizon_distance(ray.altitude);
    real root = sqrt(max(squares_apart(lowest, real(0)), real(0)));
    ray.end = below ? tangent * tangent / max(to_lowest + root, real(1e-20)) : distance_to_top(ray.altitude, ray.mu);
    return ray;
}

// The same for a direction by the cosine and sine of its zenith angle and the cosine of its azimuth from the sun's. Of no length
// where a camera above the air looks past it.
Ray camera_ray_towards(real mu, real sine, real azimuth_cosine, int sun) {
    bool below = sine_above_horizon(mu, sine) < 0;
    Ray ray = camera_ray(min(real(0.5) * chord_to_horizon(mu, sine), real(1)), below, azimuth_cosine, sun);
    if (view.camera.w > real(0.5) && mu >= 0) ray.end = real(0);
    return ray;
}

#endif
