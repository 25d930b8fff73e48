// Fills the transmittance table with Gauss-Legendre quadrature (column.glsl). See transmittance.glsl for what is stored.
#include "common/constants.glsl"
#include "common/specialization.glsl"
#include "common/blocks.glsl"

UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)

IMAGE_2D(3, transmittance_out)
SPEC_INT(8, RAY_NODES, 10)

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES RAY_NODES
#include "common/storage.glsl"
#include "transmittance/column.glsl"
#include "transmittance/transmittance.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(transmittance_out);
    if (id.x >= size.x || id.y >= size.y) return;
    vec2 p = transmittance_altitude_mu(vec2(texel_to_unit(id.x, size.x), texel_to_unit(id.y, size.y)));
    imageStore(transmittance_out, ivec2(id.x, id.y), vec4(storable(column_to_top(p.x, p.y)), real(0)));
}
