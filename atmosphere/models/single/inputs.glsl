// What every kernel of single scattering reads beyond the common inputs. Slots: 3 nodes of the view ray, 4 the table of optical
// depth (single-lut) or the nodes of the light ray (single).
#ifndef AUREOLE_SINGLE_INPUTS_GLSL
#define AUREOLE_SINGLE_INPUTS_GLSL

#define AUREOLE_PROFILE_TABLE 10

UNIFORMS(3, QuadratureBlock, quadrature)
SPEC_INT(8, RAY_NODES, 8)
CONST(bool, SINGLE_SCATTERING, true)
CONST(bool, MULTIPLE_SCATTERING, false)
SPEC_INT(30, LIGHT_NODES, 8)
SPEC_INT(31, VIEW_MIDPOINTS, 0)   // uniform steps of the view ray; 0: Gauss nodes
SPEC_INT(32, LIGHT_MIDPOINTS, 0)  // of the light ray

#endif
