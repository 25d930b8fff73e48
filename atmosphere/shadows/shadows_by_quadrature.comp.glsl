// The losses by shadows, for models without a transmittance table.
#include "shadows/inputs.glsl"
UNIFORMS(4, QuadratureBlock, quadrature)
CONST(int, SUN_NODES, 8)
#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES SUN_NODES
#include "transmittance/by_quadrature.glsl"
#include "shadows/march.glsl"
