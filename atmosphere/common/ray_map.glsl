// Where on a piece of a ray the nodes of a quadrature rule lie: t = span g / (1 + k (1 - g)), g = a u + (1 - a) u^2, u in (0, 1),
// with t counted from the end of the piece where the air is dense.
//
// Density falls by a factor e over the distance `scale`. Where the ray rises steadily that is exponential in t, which t ~ u^2
// makes smooth; where it grazes (altitude ~ t^2 / 2 R) density is a Gaussian in t already, and t ~ u is right. So a goes from 0 to 1 as
// the ray flattens. The stretch k brings half of the nodes within some scales of the dense end, however long the piece is:
// eight nodes then integrate a layer of fog a hundred metres deep along a thousand kilometres to 1 %, instead of missing it
// (docs/quadrature.md has the figures).
#ifndef AUREOLE_RAY_MAP_GLSL
#define AUREOLE_RAY_MAP_GLSL

#include "common/geometry.glsl"

CONST(real, RAY_MAP_SCALES, real(8))  // scales within which half of the nodes lie

struct RayMap {
    real span;     // length of the piece, km
    real linear;   // a
    real stretch;  // k
};

// `mu` >= 0: cosine between the vertical and the ray at its dense end, at `altitude`; `decay`: 1 / scale height there, 1/km;
// `extinction`: what else makes the integrand fall with distance from the dense end, 1/km.
RayMap ray_map(real span, real altitude, real mu, real decay, real extinction) {
    real height = 1 / max(decay, real(1e-3) / shell_thickness());
    real b = (bottom_radius() + altitude) * mu;
    real c = height * (2 * (bottom_radius() + altitude) + height);
    real scale = c / (b + sqrt(b * b + c));  // to a scale height above
    RayMap map;
    map.span = span;
    map.linear = 1 - min(scale * mu / height, real(1));
    map.stretch = max(span * (1 / scale + extinction) / RAY_MAP_SCALES - 1, real(0));
    return map;
}

// Distance from the dense end, and its derivative to u. 1 - g = (1 - u) (1 + (1 - a) u): a stretch of a million leaves nothing of the
// last digits of a difference.
real map_stretched(RayMap map, real u) { return 1 + map.stretch * (1 - u) * (1 + (1 - map.linear) * u); }
real map_distance(RayMap map, real u) {
    real g = u * (map.linear + (1 - map.linear) * u);
    return map.span * g / map_stretched(map, u);
}
real map_rate(RayMap map, real u) {
    real q = map_stretched(map, u);
    return map.span * (map.linear + 2 * (1 - map.linear) * u) * (1 + map.stretch) / (q * q);
}

#endif
