// Adds up the tables of several wavelengths (spectral_sum.glsl), textures of 3 dimensions.
#include "common/constants.glsl"
#include "models/spectral/spectral_sum.glsl"

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

LOCAL_SIZE(64, 1, 1)

COMPUTE_MAIN(id) {
    ivec3 at = ivec3(id.x, id.y + int(rows.range.x), id.z);
    ivec3 size = imageSize(sum_out);
    if (at.x >= size.x || real(at.y) >= rows.range.y || at.z >= size.z) return;
    vec3 texel[MAX_TRIPLETS];
    texel[0] = vec3(texelFetch(table_0, at, 0));
    texel[1] = TRIPLETS > 1 ? vec3(texelFetch(table_1, at, 0)) : texel[0];
    texel[2] = TRIPLETS > 2 ? vec3(texelFetch(table_2, at, 0)) : texel[0];
    texel[3] = TRIPLETS > 3 ? vec3(texelFetch(table_3, at, 0)) : texel[0];
    texel[4] = TRIPLETS > 4 ? vec3(texelFetch(table_4, at, 0)) : texel[0];
    texel[5] = TRIPLETS > 5 ? vec3(texelFetch(table_5, at, 0)) : texel[0];
    texel[6] = TRIPLETS > 6 ? vec3(texelFetch(table_6, at, 0)) : texel[0];
    texel[7] = TRIPLETS > 7 ? vec3(texelFetch(table_7, at, 0)) : texel[0];
    texel[8] = TRIPLETS > 8 ? vec3(texelFetch(table_8, at, 0)) : texel[0];
    texel[9] = TRIPLETS > 9 ? vec3(texelFetch(table_9, at, 0)) : texel[0];
    texel[10] = TRIPLETS > 10 ? vec3(texelFetch(table_10, at, 0)) : texel[0];
    texel[11] = TRIPLETS > 11 ? vec3(texelFetch(table_11, at, 0)) : texel[0];
    texel[12] = TRIPLETS > 12 ? vec3(texelFetch(table_12, at, 0)) : texel[0];
    texel[13] = TRIPLETS > 13 ? vec3(texelFetch(table_13, at, 0)) : texel[0];
    imageStore(sum_out, at, spectral_texel(texel));
}
