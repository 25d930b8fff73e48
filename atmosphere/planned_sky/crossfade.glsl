// One picture over another, while a sky gives way to the next: both as they would be shown.
#ifndef AUREOLE_CROSSFADE_GLSL
#define AUREOLE_CROSSFADE_GLSL

#include "common/constants.glsl"

SAMPLER_2D(0, picture_before)
SAMPLER_2D(1, picture_after)

struct CrossfadeShare {
    vec4 size;  // x, y: width and height of the target; z: share of picture_after, in [0, 1]
};
PUSH_CONSTANTS(CrossfadeShare, fade)

vec4 crossfade_pixel(ivec2 pixel) {
    vec4 before = texelFetch(picture_before, pixel, 0);
    return before + (texelFetch(picture_after, pixel, 0) - before) * fade.size.z;
}

#endif
