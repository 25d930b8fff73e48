// One picture over another, while a sky gives way to the next: both as they would be shown.
#ifndef AUREOLE_CROSSFADE_GLSL
#define AUREOLE_CROSSFADE_GLSL

#include "common/constants.glsl"

SAMPLER_2D(0, picture_before)
SAMPLER_2D(1, picture_after)

struct CrossfadeShare {
    vec4 size;  // x, y: width and height of the target; z: share of picture_after, between 0 and 1
};
PUSH_CONSTANTS(CrossfadeShare, fade)

vec4 crossfade_pixel(ivec2 pixel) {
    // Not before + (after - before) share, which would not end at after to the bit.
    return texelFetch(picture_before, pixel, 0) * (1 - fade.size.z) + texelFetch(picture_after, pixel, 0) * fade.size.z;
}

#endif
