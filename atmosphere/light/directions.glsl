// The directions of the light's integral over the sphere: rings of equal elevation, first from the horizon up, then from it down, by
// Gauss nodes that are squared towards the horizon; on each ring evenly spaced azimuths from the sun's. Needs `view` and
// `zenith_quadrature`.
#ifndef AUREOLE_LIGHT_DIRECTIONS_GLSL
#define AUREOLE_LIGHT_DIRECTIONS_GLSL

#include "common/constants.glsl"

CONST(int, LIGHT_ZENITHS, 8)
CONST(int, LIGHT_AZIMUTHS, 12)
CONST(int, LIGHT_RINGS, 16)  // above the horizon and below

struct LightRing {
    real mu;  // cosine and sine of the zenith angle
    real sine;
    real weight;  // solid angle of each of its directions
};
LightRing light_ring(int ring) {
    bool below = ring >= LIGHT_ZENITHS;
    vec4 node = zenith_quadrature.node[below ? ring - LIGHT_ZENITHS : ring];
    real range = below ? real(0.5) * PI - view.space.z : view.space.z - view.space.y;  // from the horizon to the last of the sky
    real s = node.x;
    real angle = range * s * s;
    real elevation = (below ? -angle : angle) - view.space.z;
    LightRing result;
    result.mu = sin(elevation);
    result.sine = max(cos(elevation), real(0));  // the last node of a planet that is a speck lies a rounding beyond the nadir
    result.weight = node.y * range * 2 * s * result.sine * (2 * PI / real(LIGHT_AZIMUTHS));
    return result;
}

struct LightDirection {
    vec3 direction;  // world axes
    real mu;         // its ring's
    real sine;
    real azimuth_cosine;
    real nu;  // cosine of the angle from the sun
};
LightDirection light_direction(int sun, LightRing ring, int azimuth_index) {
    vec3 up = vec3(view.up);
    vec3 towards = vec3(view.sun_azimuth[sun]);
    real azimuth = 2 * PI * (real(azimuth_index) + real(0.5)) / real(LIGHT_AZIMUTHS);
    LightDirection at;
    at.mu = ring.mu;
    at.sine = ring.sine;
    at.azimuth_cosine = cos(azimuth);
    at.direction = at.sine * (at.azimuth_cosine * towards + sin(azimuth) * cross(up, towards)) + at.mu * up;
    at.nu = dot(at.direction, vec3(view.sun_direction[sun]));
    return at;
}

#endif
