// crossfade.glsl as a compute pass.
#include "planned_sky/crossfade.glsl"

IMAGE_2D(2, target_out)
LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    if (real(id.x) >= fade.size.x || real(id.y) >= fade.size.y) return;
    imageStore(target_out, ivec2(id.x, id.y), crossfade_pixel(ivec2(id.x, id.y)));
}
