// Multiple scattering of Hillaire 2020, second half: all orders as the geometric series L_2nd / (1 - f_ms), stored like our
// table with the mean alone (multi_scatter.glsl, ANGULAR_ORDER 0). The published model gives the ground no diffuse light.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

UNIFORMS(0, AtmosphereBlock, atm)
SAMPLER_2D(2, rays)
IMAGE_2D(6, multi_scatter_out)

#include "multi_scatter/multi_scatter.glsl"

LOCAL_SIZE(32, 1, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(multi_scatter_out);
    if (id.x >= size.x || id.y >= size.y) return;
    vec3 mean = vec3(real(0));
    if (id.y < size.y - 1) {
        vec3 second = vec3(real(0));
        vec3 share = vec3(real(0));
        int node = id.y * size.x + id.x;
        for (int q = 0; q < 64; ++q) {
            second += vec3(texelFetch(rays, ivec2(q, 2 * node), 0));
            share += vec3(texelFetch(rays, ivec2(q, 2 * node + 1), 0));
        }
        mean = second / real(64) / max(vec3(real(1)) - share / real(64), vec3(real(1e-3)));
    }
    imageStore(multi_scatter_out, ivec2(id.x, id.y), vec4(log(max(mean, vec3(LEAST_RADIANCE))), real(0)));
}
