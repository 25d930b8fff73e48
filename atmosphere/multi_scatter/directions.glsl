// The directions along which the multi-scatter pass looks from each node of its table: Gauss-Legendre nodes in the zenith cosine
// on each side of the horizon, squared towards it, times midpoints in azimuth over the half circle that symmetry leaves.
#ifndef AUREOLE_MULTI_SCATTER_DIRECTIONS_GLSL
#define AUREOLE_MULTI_SCATTER_DIRECTIONS_GLSL

SPEC_INT(12, ZENITH_NODES, 4)
SPEC_INT(13, AZIMUTH_NODES, 4)

struct ScatterDirection {
    real mu;             // zenith cosine
    real azimuth_cosine; // from the sun's azimuth
    real solid_angle;    // weight; all weights add up to 4 pi
    bool ground;
};

int direction_count() { return 2 * ZENITH_NODES * AZIMUTH_NODES; }

ScatterDirection scatter_direction(int q, real altitude) {
    int side = q / (ZENITH_NODES * AZIMUTH_NODES);
    int zenith = (q / AZIMUTH_NODES) % ZENITH_NODES;
    int azimuth = q % AZIMUTH_NODES;
    real horizon = horizon_mu(altitude);
    real s = zenith_quadrature.node[zenith].x;
    real range = side == 0 ? 1 - horizon : 1 + horizon;
    ScatterDirection direction;
    direction.ground = side == 1;
    direction.mu = clamp(side == 0 ? horizon + range * (s * s) : horizon - range * (s * s), real(-1), real(1));
    direction.azimuth_cosine = cos(PI * (real(azimuth) + real(0.5)) / real(AZIMUTH_NODES));
    direction.solid_angle = range * 2 * s * zenith_quadrature.node[zenith].y * 2 * PI / real(AZIMUTH_NODES);
    return direction;
}

#endif
