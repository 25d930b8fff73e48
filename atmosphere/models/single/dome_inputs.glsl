// What the kernels of the dome read, in the slots of composite/inputs.glsl.
#ifndef AUREOLE_DOME_INPUTS_GLSL
#define AUREOLE_DOME_INPUTS_GLSL

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
IMAGE_2D(9, sky_view_out)

#endif
