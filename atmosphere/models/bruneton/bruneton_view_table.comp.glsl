// Fills the view table and its strip of optical depths, for a camera in the air. z of the invocation: the sun.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_SCATTERING_TABLE
#define AUREOLE_IRRADIANCE_TABLE
#define AUREOLE_PHASE_TABLE 7
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
SAMPLER_3D(2, scattering_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, irradiance_table)
IMAGE_2D(6, view_table_out)
IMAGE_2D(9, view_depth_out)

#include "models/bruneton/bruneton_rays.glsl"
#include "models/bruneton/bruneton_view_table.glsl"

LOCAL_SIZE(32, 2, 1)

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(view_table_out);
    int rows = view_table_rows(size.y);
    int nodes = imageSize(view_depth_out).x;
    int strip = id.y * size.x + id.x;
    if (id.x < size.x && id.z == 0 && strip < nodes) {
        vec3 depth = vec3(SAMPLE(transmittance_table,
                                 vec2(unit_to_texture(texel_to_unit(strip, nodes), nodes),
                                      unit_to_texture(altitude_position(view.camera.x), textureSize(transmittance_table, 0).y))));
        imageStore(view_depth_out, ivec2(strip, 0), vec4(storable(depth), real(0)));
    }
    if (id.x >= size.x || id.y >= rows || id.z >= SUN_COUNT) return;
    Ray ray = row_ray(view.camera.x, id.y, rows);
    ray.mu_s = view.sun_direction[id.z].w;
    ray.nu = 2 * texel_to_unit(id.x, size.x) - 1;

    TablePlace place = table_place_in_row(ray, real(id.y), textureSize(scattering_table, 0), scattering_layers());

    vec4 first = scattering_layer(place, 0);
    vec3 with_ground = vec3(first);
    if (ray.ground) with_ground += TABLE_SCALE / rayleigh_phase(ray.nu) * ray_ground_radiance(ray);
    vec3 most = vec3(LARGEST_STORED);
    int y = id.z * scattering_layers_apart() * rows + id.y;
    imageStore(view_table_out, ivec2(id.x, y), vec4(min(with_ground, most), real(0)));
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c))
            imageStore(view_table_out, ivec2(id.x, y + sharp_layer(c) * rows), vec4(min(sharp_light(place, first, c), most), real(0)));
}
