// The functions of transmittance.glsl without its table, for models that keep none: each call is a quadrature (column.glsl, which
// says what the including kernel declares).
#ifndef AUREOLE_BY_QUADRATURE_GLSL
#define AUREOLE_BY_QUADRATURE_GLSL

#include "transmittance/column.glsl"

vec3 optical_depth_to_top(real altitude, real mu) { return column_to_top(altitude, max(mu, horizon_mu(altitude))); }
#define AUREOLE_OPTICAL_DEPTH_TO_TOP

#include "transmittance/transmittance.glsl"

#endif
