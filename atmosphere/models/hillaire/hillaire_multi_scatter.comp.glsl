// Psi (hillaire.glsl), second half: the averages over the 64 rays of each node, and the geometric series.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/energy.glsl"
#include "common/specialization.glsl"

SAMPLER_2D(2, rays)
IMAGE_2D(6, multi_scatter_out)

LOCAL_SIZE(32, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(multi_scatter_out);
    if (id.x >= size.x || id.y >= size.y) return;
    vec3 second = vec3(real(0));
    vec3 share = vec3(real(0));
    int node = id.y * size.x + id.x;
    for (int q = 0; q < 64; ++q) {
        second += vec3(texelFetch(rays, ivec2(q, 2 * node), 0)) / real(64);
        share += vec3(texelFetch(rays, ivec2(q, 2 * node + 1), 0)) / real(64);
    }
    vec3 psi = second / max(vec3(real(1)) - share, vec3(real(1e-3)));
    imageStore(multi_scatter_out, ivec2(id.x, id.y), vec4(min(psi, vec3(MOST_MEAN_RADIANCE)), real(0)));
}
