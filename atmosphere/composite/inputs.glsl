// What every composite kernel reads, whichever model's sky it shows. Slots 2 to 4, 10, 11 and from 17 on are the model's: 10 the
// profile table (AUREOLE_PROFILE_TABLE), if it marches.
#ifndef AUREOLE_COMPOSITE_INPUTS_GLSL
#define AUREOLE_COMPOSITE_INPUTS_GLSL

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7

UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
SAMPLER_2D(5, scene_color)
SAMPLER_2D(6, scene_depth)
SAMPLER_2D(8, directions)
SAMPLER_2D(12, shadow_table)
SAMPLER_2D(13, shadow_map)
UNIFORMS(14, ShadowBlock, shadow)
SAMPLER_2D(16, sum_before)  // of the runs before (triplet.glsl, which has slot 15)

SPEC_BOOL(16, SCENE_COLOR, false)
SPEC_BOOL(17, SCENE_DEPTH, false)
SPEC_BOOL(18, AERIAL_PERSPECTIVE, false)
SPEC_BOOL(19, SUN_DISK, true)
SPEC_INT(20, TONE_MAP, 0)  // 0 none, 1 ACES as fitted by Hill
SPEC_BOOL(21, ENCODE_SRGB, false)
SPEC_BOOL(22, DITHER, false)
SPEC_BOOL(23, GIVEN_DIRECTIONS, false)
SPEC_BOOL(37, SUN_LOBE, false)  // in place of disks
SPEC_BOOL(38, SHADOWS, false)   // ViewSettings::shadows
SPEC_BOOL(53, GROUND_LOSS_GIVEN, false)  // sum_before is what ground_loss.comp.glsl has found at each triplet
SPEC_BOOL(50, NO_NEGATIVE, false)  // light from tables whose colours can lie outside of Rec.709: what is below 0 shows as 0

struct CompositeTarget {
    vec4 size;  // x, y: width and height of the target; z: frame number, for the dither
};
PUSH_CONSTANTS(CompositeTarget, target)

#include "aerial_perspective/air_before.glsl"
#include "common/triplet.glsl"
#include "common/view_ray.glsl"

#endif
