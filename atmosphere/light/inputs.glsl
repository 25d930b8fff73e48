// What every light kernel reads, whichever model's sky it is. Slots 2 to 4, 10, 11 and from 16 on are the model's (14: light.glsl,
// 15: triplet.glsl): 10 the profile table (AUREOLE_PROFILE_TABLE), if it marches.
#ifndef AUREOLE_LIGHT_INPUTS_GLSL
#define AUREOLE_LIGHT_INPUTS_GLSL

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
UNIFORMS(8, QuadratureBlock, zenith_quadrature)
IMAGE_2D(9, light_out)

#include "common/triplet.glsl"
#include "phase/smooth_phase.glsl"

#endif
