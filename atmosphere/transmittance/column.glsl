// Optical depth along a ray by Gauss-Legendre quadrature: the nodes of each term lie where it is dense, so six do better than
// forty uniform steps (docs/quadrature.md).
//
// The including kernel declares `atm` and says `#define AUREOLE_COLUMN_QUADRATURE <QuadratureBlock>` and
// `#define AUREOLE_COLUMN_NODES <its count of nodes>`.
#ifndef AUREOLE_COLUMN_GLSL
#define AUREOLE_COLUMN_GLSL

#include "common/geometry.glsl"
#include "common/ray_map.glsl"
#include "medium/medium.glsl"

// Column of one term's density over [t0, t1].
real term_column(int i, real altitude, real mu, real t0, real t1, bool dense_end) {
    real dense = dense_end ? t1 : t0;
    real h = altitude_after(altitude, mu, dense);
    real r = bottom_radius() + altitude;
    real mu_dense = min(abs(r * mu + dense) / (bottom_radius() + h), real(1));
    RayMap map = ray_map(max(t1 - t0, real(0)), h, mu_dense, term_kind(i) == PROFILE_EXPONENTIAL ? atm.term_profile[i].x : real(0), real(0));
    real sum = real(0);
    UNROLL for (int j = 0; j < AUREOLE_COLUMN_NODES; ++j) {
        real u = AUREOLE_COLUMN_QUADRATURE.node[j].x;
        real s = map_distance(map, u);
        sum += term_density(i, altitude_after(altitude, mu, dense_end ? t1 - s : t0 + s)) * (AUREOLE_COLUMN_QUADRATURE.node[j].y * map_rate(map, u));
    }
    return sum;
}

// Optical depth of [t0, t1], on which altitude is monotone. Each term by itself: a tent is linear in altitude between its feet
// and its tip, so the ray is cut there and the nodes converge on each part, which they would not do across a kink; a table's
// kinks are unknown, so its ray is cut in eight, squared like the nodes, so that the parts are short where the air is dense.
vec3 column(real altitude, real mu, real t0, real t1, bool upwards) {
    vec3 depth = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) {
        int kind = term_kind(i);
        int parts = kind == PROFILE_TENT ? 2 : (kind == PROFILE_TABULATED ? 8 : 1);
        real tip = atm.term_profile[i].x;
        real sum = real(0);
        int part = 0;
        do {  // tested at the end: see march.glsl. One place that integrates: kernels with many columns stay short
            real a = real(part) / real(parts);
            real b = real(part + 1) / real(parts);
            real from = upwards ? mix(t0, t1, a * a) : mix(t1, t0, b * b);
            real to = upwards ? mix(t0, t1, b * b) : mix(t1, t0, a * a);
            if (kind == PROFILE_TENT) {
                real half_width = 1 / atm.term_profile[i].y;
                real outer = part == 0 ? tip - half_width : tip + half_width;
                // Below the ground nothing is cut off: a ray that grazes it would lose what a rounding puts there.
                real foot = upwards ? t0 : t1;
                real p = outer > 0 ? clamp(distance_to_altitude(altitude, mu, outer, upwards), t0, t1) : foot;
                real q = tip > 0 ? clamp(distance_to_altitude(altitude, mu, tip, upwards), t0, t1) : foot;
                from = min(p, q);
                to = max(p, q);
            }
            sum += term_column(i, altitude, mu, from, to, !upwards);
            ++part;
        } while (part < parts);
        depth += sum * vec3(atm.term_extinction[i]);
    }
    return depth;
}

// Optical depth of the first `end` km of a ray. One that starts downwards is cut at its lowest point; a ray that hits the ground
// ends before it.
vec3 optical_depth_along(real altitude, real mu, real end) {
    real lowest = clamp(-(bottom_radius() + altitude) * mu, real(0), end);
    vec3 depth = vec3(real(0));
    bool upwards = lowest <= 0;
    for (int piece = 0; piece < 2; ++piece) {
        COUNT(AUREOLE_COLUMN_NODES);
        depth += column(altitude, mu, upwards ? lowest : real(0), upwards ? end : lowest, upwards);
        if (upwards || lowest >= end) break;
        upwards = true;
    }
    return depth;
}

// To the top of the shell, for directions above the horizon.
vec3 column_to_top(real altitude, real mu) { return optical_depth_along(altitude, mu, distance_to_top(altitude, mu)); }

#endif
