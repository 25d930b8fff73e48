// A composite kernel as a compute pass.
#ifndef AUREOLE_COMPOSITE_COMPUTE_GLSL
#define AUREOLE_COMPOSITE_COMPUTE_GLSL

#include "composite/composite.glsl"

IMAGE_2D(9, target_out)
LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    if (real(id.x) >= target.size.x || real(id.y) >= target.size.y) return;
    imageStore(target_out, ivec2(id.x, id.y), composite_pixel(ivec2(id.x, id.y)));
}

#endif
