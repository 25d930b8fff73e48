// Rays of the camera's sky. Needs `atm`, `view`, geometry.glsl.
#ifndef AUREOLE_CAMERA_RAY_GLSL
#define AUREOLE_CAMERA_RAY_GLSL

// A ray of the camera, at the angle a from the horizon (negative below it), moved to where it enters the shell if the camera is
// above it. Given is sin(a / 2): with it and the dip's cosine and sine no trigonometric function is needed, whose inverses devices
// compute to four digits only.
//
// With e = a - d the elevation of the ray, d the dip of the horizon (r cos d = R), the tangent point's altitude p - R is
// r cos(e) - R = r (cos(d - a) - cos d) = 2 r sin(d - a / 2) sin(a / 2): no cancellation, so the limb is exact from any distance.
// On the shell's top mu^2 = 1 - (p / T)^2 = (T - p) (T + p) / T^2.
Ray camera_ray(real half_sine, real azimuth_cosine, int sun) {
    bool space = view.camera.w > real(0.5);
    real dip_cosine = view.horizon.x;
    real dip_sine = view.horizon.y;
    real half_cosine = sqrt(max(1 - half_sine * half_sine, real(0)));
    real angle_sine = 2 * half_sine * half_cosine;
    real angle_cosine = 1 - 2 * half_sine * half_sine;
    real mu = clamp(angle_sine * dip_cosine - angle_cosine * dip_sine, real(-1), real(1));
    real sine = max(angle_cosine * dip_cosine + angle_sine * dip_sine, real(0));
    Ray ray;
    ray.ground = half_sine < 0;
    ray.mu_s = view.sun_direction[sun].w;
    ray.nu = clamp(mu * ray.mu_s + sine * view.sun_azimuth[sun].w * azimuth_cosine, real(-1), real(1));
    ray.altitude = view.camera.x;
    ray.mu = mu;
    if (space) {
        real radius = bottom_radius();
        real top = radius + shell_thickness();
        real r = radius + view.space.x;
        real lowest = 2 * r * (dip_sine * half_cosine - dip_cosine * half_sine) * half_sine;
        real half_chord = sqrt(max((shell_thickness() - lowest) * (top + radius + lowest), real(0)));
        real t = max(-r * mu - half_chord, real(0));
        ray.altitude = shell_thickness();
        ray.mu = -half_chord / top;
        ray.mu_s = clamp((r * ray.mu_s + t * ray.nu) / top, real(-1), real(1));
    }
    // The horizon itself belongs to the upper side: its ray passes the ground at height 0.
    ray.end = ray.ground ? distance_to_ground(ray.altitude, ray.mu) : distance_to_top(ray.altitude, ray.mu);
    return ray;
}

#endif
