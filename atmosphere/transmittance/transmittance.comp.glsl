// Fills the transmittance table with Gauss-Legendre quadrature: t = D u^2 puts the nodes where the air is dense, so ten nodes
// do better than forty uniform steps (docs: quadrature). See transmittance.glsl for what is stored.
#include "common/constants.glsl"
#include "common/specialization.glsl"
#include "common/blocks.glsl"

UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)

IMAGE_2D(3, transmittance_out)
SPEC_INT(8, RAY_NODES, 10)

#define AUREOLE_PROFILE_TABLE 2
#include "common/geometry.glsl"
#include "medium/medium.glsl"
#include "transmittance/transmittance.glsl"

LOCAL_SIZE(64, 1, 1)

// Rays that graze the ground dip before they rise only below the horizon, which the table excludes: every ray ascends, or
// descends to a tangent point above the ground and ascends again; the integral is split there.
vec3 column(real altitude, real mu, real t0, real t1, bool dense_end) {
    vec3 sum = vec3(real(0));
    real span = t1 - t0;
    for (int j = 0; j < RAY_NODES; ++j) {
        real u = quadrature.node[j].x;
        real s = span * u * u;
        real t = dense_end ? t1 - s : t0 + s;
        sum += medium_extinction(altitude_after(altitude, mu, t)) * (quadrature.node[j].y * 2 * span * u);
    }
    return sum;
}

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(transmittance_out);
    if (id.x >= size.x || id.y >= size.y) return;
    vec2 p = transmittance_altitude_mu(vec2(texel_to_unit(id.x, size.x), texel_to_unit(id.y, size.y)));
    real end = distance_to_top(p.x, p.y);
    real tangent = clamp(-(bottom_radius() + p.x) * p.y, real(0), end);
    vec3 depth = column(p.x, p.y, tangent, end, false);
    if (tangent > 0) depth += column(p.x, p.y, real(0), tangent, true);
    imageStore(transmittance_out, ivec2(id.x, id.y), vec4(depth, real(0)));
}
