// Adds up the tables of several wavelengths (spectral_sum.glsl), textures of 2 dimensions.
#include "common/constants.glsl"

IMAGE_2D(1, sum_out)
SAMPLER_2D(2, table_0)
SAMPLER_2D(3, table_1)
SAMPLER_2D(4, table_2)
SAMPLER_2D(5, table_3)
SAMPLER_2D(6, table_4)
SAMPLER_2D(7, table_5)
SAMPLER_2D(8, table_6)
SAMPLER_2D(9, table_7)
SAMPLER_2D(10, table_8)
SAMPLER_2D(11, table_9)
SAMPLER_2D(12, table_10)
SAMPLER_2D(13, table_11)
SAMPLER_2D(14, table_12)
SAMPLER_2D(15, table_13)

#define AUREOLE_TEXEL ivec2
#include "models/spectral/spectral_sum.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 at = ivec2(id.x, id.y + int(rows.range.x));
    ivec2 size = imageSize(sum_out);
    if (at.x >= size.x || real(at.y) >= rows.range.y) return;
    imageStore(sum_out, at, spectral_texel(at));
}
