// Adds up the tables of several wavelengths (spectral_sum.glsl), textures of 3 dimensions.
#include "common/constants.glsl"

IMAGE_3D(1, sum_out)
SAMPLER_3D(2, table_0)
SAMPLER_3D(3, table_1)
SAMPLER_3D(4, table_2)
SAMPLER_3D(5, table_3)
SAMPLER_3D(6, table_4)
SAMPLER_3D(7, table_5)
SAMPLER_3D(8, table_6)
SAMPLER_3D(9, table_7)
SAMPLER_3D(10, table_8)
SAMPLER_3D(11, table_9)
SAMPLER_3D(12, table_10)
SAMPLER_3D(13, table_11)
SAMPLER_3D(14, table_12)
SAMPLER_3D(15, table_13)

#define AUREOLE_TEXEL ivec3
#include "models/spectral/spectral_sum.glsl"

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec3 at = ivec3(id.x, id.y + int(rows.range.x), id.z);
    ivec3 size = imageSize(sum_out);
    if (at.x >= size.x || real(at.y) >= rows.range.y || at.z >= size.z) return;
    imageStore(sum_out, at, spectral_texel(at));
}
