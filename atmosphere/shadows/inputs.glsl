// What both kernels of shadows read; whence the sun's transmittance comes they say themselves.
#ifndef AUREOLE_SHADOWS_INPUTS_GLSL
#define AUREOLE_SHADOWS_INPUTS_GLSL

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
UNIFORMS(2, ShadowBlock, shadow)
SAMPLER_2D(5, shadow_map)
IMAGE_2D(6, shadows_out)
SAMPLER_2D(8, sum_before)  // of the triplets before (triplet.glsl, which has slot 15)
SPEC_INT(41, SHADOW_SAMPLES, 1)

#include "common/triplet.glsl"

#endif
