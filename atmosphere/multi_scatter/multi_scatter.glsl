// Multiple scattering that keeps its direction, in a table over (altitude, mu_s).
//
// Away from the sun's own beam the scattered field is smooth, and a phase function passes on only the Legendre moments that it
// has: Rayleigh exactly l = 0 and 2 (p_0 = 1, p_2 = 1/10). So it is enough to know, at each altitude and sun cosine, the moments
// of the scattered radiance L up to l = ANGULAR_ORDER in real spherical harmonics that are symmetric about the vertical plane
// of the sun (z up, x towards the sun's azimuth). With y_lm = Y_lm / Y_00 the table holds
//   layer 0:               ln J, where J = 1/(4 pi) integral L, the mean radiance,
//   layer l (l + 1)/2 + m: n_lm b_lm, where b_lm = integral L y_lm / integral L and n_lm is the norm of y_lm, for
//                          1 <= l <= ANGULAR_ORDER, 0 <= m <= l (times the norm, so that look-ups need none),
//   one more row:          ln E, the diffuse irradiance of the ground (over mu_s alone),
// stacked in y, rgb, per unit solar irradiance. Light scattered once more from all directions into v is then
//   S(v) = J sum_c sigma_c (1 + sum_{l >= 1} p_l^c sum_m b_lm y_lm(v)).
// Logarithms, because twilight falls by orders of magnitude over a few degrees: interpolating ln J is exact for an exponential,
// and the ratios b are smooth. ANGULAR_ORDER 0 keeps the mean alone: the isotropy assumption of Hillaire 2020.
#ifndef AUREOLE_MULTI_SCATTER_GLSL
#define AUREOLE_MULTI_SCATTER_GLSL

#include "common/geometry.glsl"
#include "multi_scatter/moments.glsl"
#include "transmittance/transmittance.glsl"

SPEC_INT(9, ANGULAR_ORDER, 2)
CONST(int, MAX_ANGULAR_ORDER, 8)
CONST(int, MAX_MOMENTS, 45)
CONST(real, LEAST_RADIANCE, real(1e-30))

int moment_count() { return moments_up_to(ANGULAR_ORDER); }
int moment_layer(int l, int m) { return moments_up_to(l - 1) + m; }

// Axis of the sun cosine: dense around the terminator, where the field changes fast. x = (mu_s - c) / (w + |mu_s - c|).
// Centre and width follow the planet: they scale with the dip of the horizon seen from the top of the air. The last node is the zenith
// to the last digit: there light knows no azimuth, and a trace of one would grow with every order in air of a hundred optical depths.
real sun_position(real mu_s) {
    real d = mu_s - atm.sun_mapping.x;
    return (d / (atm.sun_mapping.y + abs(d)) - atm.sun_mapping.z) / (atm.sun_mapping.w - atm.sun_mapping.z);
}
real sun_mu_at(real position) {
    real x = atm.sun_mapping.z + position * (atm.sun_mapping.w - atm.sun_mapping.z);
    if (position >= 1) return real(1);
    return clamp(atm.sun_mapping.x + atm.sun_mapping.y * x / (1 - abs(x)), real(-1), real(1));
}
// Axis of altitude: altitude_position (geometry.glsl), as in the transmittance table.

// Norm of y_lm: sqrt((2 l + 1) (2 - [m = 0]) (l - m)! / (l + m)!).
real harmonic_norm(int l, int m) {
    real f = real(2 * l + 1);
    for (int q = l - m + 1; q <= l + m; ++q) f /= real(q);
    return sqrt(m > 0 ? 2 * f : f);
}

// y_lm(v) / norm for v with components z (up) and x (towards the sun), as a product of two polynomials: P_lm / sin^m and
// sin^m cos(m phi). One step of each of the recurrences
//   (l - m) P_lm = (2 l - 1) z P_(l-1)m - (l + m - 1) P_(l-2)m,  P_mm = (2 m - 1)!!,
//   C_(m+1) = 2 x C_m - sin^2 C_(m-1),
// from P_lm to P_(l+1)m, from P_mm to P_(m+1)(m+1), from C_m to C_(m+1). Before the first of each stands 0.
real next_degree(int l, int m, real z, real p, real p_before) {
    return (real(2 * l + 1) * z * p - real(l + m) * p_before) / real(l + 1 - m);
}
real next_diagonal(int m, real p_mm) { return p_mm * real(2 * m + 1); }
real next_azimuthal(int m, real x, real sine_squared, real c, real c_before) {
    return (m == 0 ? x : 2 * x * c) - sine_squared * c_before;
}

// y_lm / norm at one direction, by all steps of them.
real harmonic(int l, int m, real z, real x) {
    real sine_squared = (1 - z) * (1 + z);
    real p = real(1);
    real c = real(1);
    real c_before = real(0);
    for (int k = 0; k < m; ++k) {
        p = next_diagonal(k, p);
        real c_next = next_azimuthal(k, x, sine_squared, c, c_before);
        c_before = c;
        c = c_next;
    }
    real p_before = real(0);
    for (int k = m; k < l; ++k) {
        real p_next = next_degree(k, m, z, p, p_before);
        p_before = p;
        p = p_next;
    }
    return p * c;
}

#ifdef AUREOLE_MULTI_SCATTER_TABLE
vec3 multi_scatter_layer(vec2 position, int layer, ivec2 size, int rows) {
    real row = real(layer * rows) + real(0.5) + position.y * real(rows - 1);
    return vec3(SAMPLE(multi_scatter_table, vec2(unit_to_texture(position.x, size.x), row / real(size.y))));
}

vec3 ground_diffuse_irradiance(real mu_s) {
    ivec2 size = textureSize(multi_scatter_table, 0);
    real row = (real(size.y) - real(0.5)) / real(size.y);
    return exp(vec3(SAMPLE(multi_scatter_table, vec2(unit_to_texture(sun_position(mu_s), size.x), row))));
}

// S(v) above: what the diffuse field at a point sends into the ray (view zenith cosine mu, cosine nu between view and sun).
vec3 scattered_diffuse(real altitude, real mu, real mu_s, real nu, vec3 scattering[MAX_PHASES]) {
    ivec2 size = textureSize(multi_scatter_table, 0);
    int rows = (size.y - 1) / moment_count();
    vec2 position = vec2(sun_position(mu_s), altitude_position(altitude));
    vec3 mean = exp(multi_scatter_layer(position, 0, size, rows));

    // Component of v towards the sun's azimuth. With the sun at the zenith the odd moments vanish, whatever x.
    real sine_squared = (1 - mu) * (1 + mu);
    real limit = sqrt(max(sine_squared, real(0)));
    real x = clamp((nu - mu * mu_s) / sqrt(max((1 - mu_s) * (1 + mu_s), real(1e-6))), -limit, limit);

    vec3 by_degree[MAX_ANGULAR_ORDER + 1];
    for (int l = 0; l <= ANGULAR_ORDER; ++l) by_degree[l] = vec3(real(0));
    real p_mm = real(1);
    real c_before = real(0);
    real c_m = real(1);
    int m = 0;
    do {  // loops that must not run an empty round are tested at their end: see march.glsl
        real p = p_mm;
        real p_before = real(0);
        int l = m;
        do {
            if (l > 0)
                by_degree[l] += (p * c_m) * multi_scatter_layer(position, moment_layer(l, m), size, rows);
            real p_next = next_degree(l, m, mu, p, p_before);
            p_before = p;
            p = p_next;
            ++l;
        } while (l <= ANGULAR_ORDER);
        real c_next = next_azimuthal(m, x, sine_squared, c_m, c_before);
        c_before = c_m;
        c_m = c_next;
        p_mm = next_diagonal(m, p_mm);
        ++m;
    } while (m <= ANGULAR_ORDER);

    vec3 sum = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) {
        vec3 factor = vec3(real(1));
        for (int l = 1; l <= ANGULAR_ORDER; ++l) factor += atm.phase_moments[3 * c + l / 4][l % 4] * by_degree[l];
        sum += scattering[c] * factor;
    }
    // The truncated series can dip below 0 where the field is weak.
    return mean * max(sum, vec3(real(0)));
}
#endif

#endif
