// How far each block of samples of the tabulated profiles departs from a straight line in altitude between its ends (bends.glsl):
// rows as in profile_table, a texel a block.
#include "common/constants.glsl"

#include "models/reference/bends.glsl"

SAMPLER_2D(0, profile_table)
IMAGE_2D(1, bends_out)

LOCAL_SIZE(64, 1, 1)

real profile_sample(int i, int row) { return texelFetch(profile_table, ivec2(i, row), 0).x; }

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(bends_out);
    if (id.x >= size.x || id.y >= size.y) return;
    int last = textureSize(profile_table, 0).x - 1;
    int begin = id.x * BEND_BLOCK;
    int end = min(begin + BEND_BLOCK, last);
    real d0 = profile_sample(begin, id.y);
    real d1 = profile_sample(end, id.y);
    real h0 = sample_height(begin, last);
    real h1 = sample_height(end, last);
    real below = real(0);
    real above = real(0);
    real bend_below = real(0);
    real bend_above = real(0);
    for (int i = begin; i < end; ++i) {
        real here = profile_sample(i, id.y);
        real apart = here - mix(d0, d1, (sample_height(i, last) - h0) / (h1 - h0));
        below = min(below, apart);
        above = max(above, apart);
        real bend = cell_bend(i, profile_sample(i + 1, id.y) - here);
        bend_below = min(bend_below, bend);
        bend_above = max(bend_above, bend);
    }
    imageStore(bends_out, ivec2(id.x, id.y), vec4(above + bend_above - below - bend_below, real(0), real(0), real(0)));
}
