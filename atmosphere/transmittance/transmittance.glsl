// Transmittance table: optical depth (rgb) from (altitude, mu) to the top of the shell, for directions above the horizon.
// Optical depth, not its exponential, is stored: it is smooth, so a small table interpolates well, and thick air does not
// underflow. The axes are Bruneton 2017's: altitude_position (geometry.glsl), and the distance to the top between its least
// (straight up) and greatest (grazing the ground) value. Needs `atm`, geometry.glsl, `transmittance_table`.
#ifndef AUREOLE_TRANSMITTANCE_GLSL
#define AUREOLE_TRANSMITTANCE_GLSL

// Position in [0, 1] to texture coordinate, 0 and 1 at the centres of the first and last texel.
real unit_to_texture(real x, int size) { return (real(0.5) + x * real(size - 1)) / real(size); }
real texel_to_unit(int i, int size) { return real(i) / real(size - 1); }

// (u, v) in [0, 1]^2 of a point and direction.
vec2 transmittance_position(real altitude, real mu) {
    real rho = horizon_distance(altitude);
    real d = distance_to_top(altitude, mu);
    real d_min = shell_thickness() - altitude;
    real d_max = rho + atm.radii.w;
    return vec2(clamp((d - d_min) / max(d_max - d_min, real(1e-20)), real(0), real(1)), altitude_position(altitude));
}

// The inverse: altitude and mu of a position. mu from the distance d: T^2 = r^2 + 2 r d mu + d^2.
real transmittance_mu(real altitude, real x) {
    real rho = horizon_distance(altitude);
    real d_min = shell_thickness() - altitude;
    real d = d_min + x * (rho + atm.radii.w - d_min);
    real c = squares_apart(altitude, shell_thickness());
    real mu = d > 0 ? (c - d * d) / (2 * (bottom_radius() + altitude) * d) : real(1);
    return clamp(mu, real(-1), real(1));
}
vec2 transmittance_altitude_mu(vec2 position) {
    real altitude = altitude_at(position.y);
    return vec2(altitude, transmittance_mu(altitude, position.x));
}

#ifdef AUREOLE_TRANSMITTANCE_TABLE
// Optical depth to the top. Below the horizon the value of the horizon is returned: callers know what the ground blocks.
vec3 optical_depth_to_top(real altitude, real mu) {
    vec2 position = transmittance_position(altitude, max(mu, horizon_mu(altitude)));
    ivec2 size = textureSize(transmittance_table, 0);
    return vec3(SAMPLE(transmittance_table, vec2(unit_to_texture(position.x, size.x), unit_to_texture(position.y, size.y))));
}
#define AUREOLE_OPTICAL_DEPTH_TO_TOP
#endif

// From the table, or from an optical_depth_to_top of the kernel's own, which says `#define AUREOLE_OPTICAL_DEPTH_TO_TOP` before
// this file is included.
#ifdef AUREOLE_OPTICAL_DEPTH_TO_TOP
vec3 transmittance_to_top(real altitude, real mu) { return exp(-optical_depth_to_top(altitude, mu)); }

// To the sun, a point: 0 behind the ground.
vec3 transmittance_to_sun(real altitude, real mu_s) {
    return hits_ground(altitude, mu_s) ? vec3(real(0)) : transmittance_to_top(altitude, mu_s);
}

// What the sun's beam gives the ground, per unit of its irradiance.
vec3 ground_beam_irradiance(real mu_s) { return max(mu_s, real(0)) * transmittance_to_sun(real(0), mu_s); }
#endif

#endif
