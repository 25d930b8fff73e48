// Rays through a spherical shell. A point is (altitude, mu): its height above the ground and the cosine of the zenith angle of
// a direction there; never a radius alone. The altitude form of every distance avoids r^2 - R^2 of two large numbers: in float,
// one ulp of R^2 is a third of a metre of altitude and two kilometres of grazing distance, while here the error of an altitude
// found along a ray of start altitude h is about 1e-7 h. Lengths in km. Needs `atm`.
#ifndef AUREOLE_GEOMETRY_GLSL
#define AUREOLE_GEOMETRY_GLSL

real bottom_radius() { return atm.radii.x; }
real shell_thickness() { return atm.radii.z; }

// r_b^2 - r_a^2 of two altitudes, without the squares.
real squares_apart(real a, real b) { return (b - a) * (2 * bottom_radius() + b + a); }

// sqrt(r^2 - R^2): distance to the horizon of a point at `altitude`.
real horizon_distance(real altitude) { return sqrt(squares_apart(real(0), altitude)); }
// The altitude in the shell from which the horizon is that far away: r - R = rho^2 / (R + r).
real altitude_of_horizon_distance(real rho) {
    real radius = bottom_radius();
    return min(rho * rho / (radius + sqrt(radius * radius + rho * rho)), shell_thickness());
}

// Axis of altitude of the tables: rho / rho_top, Bruneton 2017's, which is dense at the ground; denser still by the stretch s >= 0
// where air lies so low that its scale height would fall between two nodes: v (1 + s) / (1 + s v).
real altitude_position(real altitude) {
    real v = horizon_distance(altitude) / atm.radii.w;
    return v * (1 + atm.tables.z) / (1 + atm.tables.z * v);
}
real altitude_at(real position) {
    return altitude_of_horizon_distance(atm.radii.w * position / (1 + atm.tables.z * (1 - position)));
}

// Cosine of the zenith angle of the horizon: -sqrt(1 - (R/r)^2).
real horizon_mu(real altitude) { return -horizon_distance(altitude) / (bottom_radius() + altitude); }

// Altitude after a distance t: (r_t - R) (r_t + R) = r^2 + 2 r mu t + t^2 - R^2, where r^2 - R^2 = h (2 R + h).
real altitude_after(real altitude, real mu, real t) {
    real r = bottom_radius() + altitude;
    real gain = t * (t + 2 * r * mu);
    real r_t = sqrt(max(r * r + gain, real(0)));
    return max((squares_apart(real(0), altitude) + gain) / (r_t + bottom_radius()), real(0));
}

// Distance to the top of the shell from inside. T^2 - r^2 = (H - h) (2 R + H + h) >= 0, so the larger root of
// t^2 + 2 r mu t - (T^2 - r^2) = 0 is taken in the form without cancellation for either sign of mu.
real distance_to_top(real altitude, real mu) {
    real b = (bottom_radius() + altitude) * mu;
    real c = max(squares_apart(altitude, shell_thickness()), real(0));
    real root = sqrt(b * b + c);
    return mu > 0 ? c / max(b + root, real(1e-20)) : root - b;
}

// From the top of the shell to the lowest point of a line through it, which lies at the altitude `lowest` (negative: below the
// ground). 0 for a line that passes above the shell.
real half_chord(real lowest) { return sqrt(max(squares_apart(lowest, shell_thickness()), real(0))); }

// Distance to where the ray passes another altitude: on its way up from its lowest point, or on its way down to it. Where it
// never gets that low, the distance of the lowest point.
real distance_to_altitude(real altitude, real mu, real target, bool upwards) {
    real b = (bottom_radius() + altitude) * mu;
    real c = max(squares_apart(altitude, target), -(b * b));
    real root = sqrt(max(b * b + c, real(0)));
    if (upwards) return b > 0 ? c / max(b + root, real(1e-20)) : root - b;
    return b < 0 ? -c / max(root - b, real(1e-20)) : -b - root;
}

// Distance to the ground of a ray that hits it (mu at or below the horizon's).
real distance_to_ground(real altitude, real mu) {
    real b = (bottom_radius() + altitude) * mu;
    real c = squares_apart(real(0), altitude);
    real root = sqrt(max(b * b - c, real(0)));
    return c / max(root - b, real(1e-20));
}

// The same of a ray whose line is known to have its lowest point at the altitude `lowest` <= 0: exact near the horizon.
real distance_to_ground_over(real altitude, real mu, real lowest) {
    real b = (bottom_radius() + altitude) * mu;
    return squares_apart(real(0), altitude) / max(sqrt(max(squares_apart(lowest, real(0)), real(0))) - b, real(1e-20));
}

bool hits_ground(real altitude, real mu) { return mu < horizon_mu(altitude); }

// A ray inside the shell with the sun's place relative to it: mu_s is the sun's zenith cosine at the start, nu the cosine
// between ray and sun.
struct Ray {
    real altitude, mu, mu_s, nu;
    real end;      // length, km
    bool ground;   // ends on the ground, else at the top
};

// The sun's zenith cosine after a distance t: r_t mu_s(t) = r mu_s + t nu.
real sun_mu_after(Ray ray, real t, real altitude_t) {
    real r = bottom_radius() + ray.altitude;
    return clamp((r * ray.mu_s + t * ray.nu) / (bottom_radius() + altitude_t), real(-1), real(1));
}
real view_mu_after(Ray ray, real t, real altitude_t) {
    real r = bottom_radius() + ray.altitude;
    return clamp((r * ray.mu + t) / (bottom_radius() + altitude_t), real(-1), real(1));
}

// The part of the ray in the planet's shadow, a half cylinder of radius R around the anti-sun axis: the roots of
//   (1 - nu^2) t^2 + 2 r (mu - mu_s nu) t + r^2 (1 - mu_s^2) - R^2 = 0
// between which the point lies inside the cylinder, if it lies behind the planet (r mu_s + t nu < 0). Returns (begin, end)
// clipped to the ray; begin = end where none of it is in shadow. r^2 sin^2 - R^2 is written with the altitude.
vec2 shadow_interval(Ray ray) {
    real radius = bottom_radius();
    real r = radius + ray.altitude;
    real sine = sqrt(max(1 - ray.mu_s * ray.mu_s, real(0)));
    real a = max(1 - ray.nu * ray.nu, real(1e-7));
    real b = r * (ray.mu - ray.mu_s * ray.nu);
    real c = (ray.altitude * sine - radius * ray.mu_s * ray.mu_s / (1 + sine)) * (r * sine + radius);
    real discriminant = b * b - a * c;
    if (discriminant <= 0) return vec2(real(0), real(0));
    real q = -(b + (b < 0 ? -sqrt(discriminant) : sqrt(discriminant)));
    real t1 = q / a;
    real t2 = abs(q) > real(1e-20) ? c / q : real(0);
    real begin = clamp(min(t1, t2), real(0), ray.end);
    real end = clamp(max(t1, t2), real(0), ray.end);
    bool behind = r * ray.mu_s + real(0.5) * (begin + end) * ray.nu < 0;
    return behind ? vec2(begin, end) : vec2(real(0), real(0));
}

#endif
