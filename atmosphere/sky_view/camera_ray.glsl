// Rays of the camera's sky. Needs `atm`, `view`, geometry.glsl.
#ifndef AUREOLE_CAMERA_RAY_GLSL
#define AUREOLE_CAMERA_RAY_GLSL

// A ray of the camera, `angle` away from the horizon, moved to where it enters the shell if the camera is above it.
//
// With e the elevation of the ray, the tangent point's altitude p - R = r cos(e) - R is, for a ray `angle` above the horizon
// seen under the dip d (r cos d = R), r (cos(d - angle) - cos d) = 2 r sin(d - angle / 2) sin(angle / 2): no cancellation, so
// the limb is exact from any distance. On the shell's top mu^2 = 1 - (p / T)^2 = (T - p) (T + p) / T^2.
Ray camera_ray(real angle, real azimuth_cosine, int sun) {
    bool space = view.camera.w > real(0.5);
    real dip = view.space.z;
    real elevation = angle - dip;
    real mu = sin(elevation);
    real sine = cos(elevation);
    Ray ray;
    ray.ground = angle < 0;
    ray.mu_s = view.sun_direction[sun].w;
    ray.nu = clamp(mu * ray.mu_s + sine * view.sun_azimuth[sun].w * azimuth_cosine, real(-1), real(1));
    ray.altitude = view.camera.x;
    ray.mu = mu;
    if (space) {
        real radius = bottom_radius();
        real top = radius + shell_thickness();
        real r = radius + view.space.x;
        real lowest = 2 * r * sin(dip - real(0.5) * angle) * sin(real(0.5) * angle);
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
