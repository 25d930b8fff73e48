// Optical depth towards the sun by a march of its own at every place that asks: no table.
#ifndef AUREOLE_SINGLE_NESTED_GLSL
#define AUREOLE_SINGLE_NESTED_GLSL

#include "models/single/inputs.glsl"

UNIFORMS(4, QuadratureBlock, light_quadrature)
#define AUREOLE_COLUMN_QUADRATURE light_quadrature
#define AUREOLE_COLUMN_NODES LIGHT_NODES
#include "transmittance/column.glsl"

// By the midpoints of uniform steps to the top, as Nishita 1993 and its followers march.
vec3 midpoint_column(real altitude, real mu) {
    real step_km = distance_to_top(altitude, mu) / real(LIGHT_MIDPOINTS);
    vec3 extinction = vec3(real(0));
    for (int i = 0; i < LIGHT_MIDPOINTS; ++i)
        extinction += medium_extinction(altitude_after(altitude, mu, (real(i) + real(0.5)) * step_km));
    return extinction * step_km;
}

vec3 optical_depth_to_top(real altitude, real mu) {
    real above = max(mu, horizon_mu(altitude));
    if (LIGHT_MIDPOINTS > 0) return midpoint_column(altitude, above);
    return column_to_top(altitude, above);
}
#define AUREOLE_OPTICAL_DEPTH_TO_TOP

#endif
