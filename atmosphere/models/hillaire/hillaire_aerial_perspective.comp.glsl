// Froxels as published: each marched from the camera with two steps a slice in front of it, all phase functions applied.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, multi_scatter_table)
UNIFORMS(5, ViewBlock, view)
IMAGE_3D(6, froxels_out)

#include "common/view_ray.glsl"
#include "models/hillaire/hillaire.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "aerial_perspective/store.glsl"

LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    ivec3 size = imageSize(froxels_out);
    int rows = size.y / froxel_layers();
    int sun = id.y / rows;
    if (id.x >= size.x || sun >= SUN_COUNT || id.z >= size.z) return;
    int row = id.y % rows;
    ViewRay pixel = view_ray(texel_to_unit(id.x, size.x), texel_to_unit(row, rows));
    ViewDirection direction = view_direction(pixel.direction);
    real entry = distance_to_air(direction);
    Ray ray = air_ray(direction, max(entry, real(0)), sun, dot(pixel.direction, vec3(view.sun_direction[sun])));
    real position = texel_to_unit(id.z, size.z);
    ray.end = entry < 0 ? real(0) : min(view.froxels.x * position * position, distance_to_top(ray.altitude, ray.mu));
    RayLight light = march_steps(ray, 2 * id.z + 2, false);
    vec3 radiance = light.multiple;
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (!phase_is_sharp(c)) radiance += light.single[c] * phase_value(c, ray.nu);
    vec3 depth = GREY_TRANSMITTANCE ? -log(max(transmittance_shown(light.depth), vec3(real(1e-30)))) : light.depth;
    store_froxel(ivec3(id.x, row, id.z), rows, sun, depth, radiance, light.single);
}
