// The directions over which light that arrives at a point is integrated: ours (multi_scatter/directions.glsl), or the published
// ones: midpoints of even steps in zenith angle and azimuth. Needs `zenith_quadrature`.
#ifndef AUREOLE_BRUNETON_DIRECTIONS_GLSL
#define AUREOLE_BRUNETON_DIRECTIONS_GLSL

#include "common/constants.glsl"
#include "common/geometry.glsl"
#include "multi_scatter/directions.glsl"

SPEC_BOOL(32, PUBLISHED_STEPS, false)

// With the published steps ZENITH_NODES counts half of the zenith angles, so that both rules have as many directions.
ScatterDirection arriving_direction(int q, real altitude) {
    if (!PUBLISHED_STEPS) return scatter_direction(q, altitude);
    int zenith = q / AZIMUTH_NODES;
    real step_angle = PI / real(2 * ZENITH_NODES);
    real angle = step_angle * (real(zenith) + real(0.5));
    ScatterDirection direction;
    direction.mu = cos(angle);
    direction.azimuth_cosine = cos(PI * (real(q % AZIMUTH_NODES) + real(0.5)) / real(AZIMUTH_NODES));
    direction.solid_angle = sin(angle) * step_angle * 2 * PI / real(AZIMUTH_NODES);
    direction.ground = hits_ground(altitude, direction.mu);
    return direction;
}

#endif
