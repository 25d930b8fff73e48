// What the two kernels have in common that integrate along the ray of each texel of the 4D table. Before it, the kernel declares
// `source_table` if it reads one, MULTIPLE_SCATTERING, and scattered_diffuse (common/march.glsl).
#ifndef AUREOLE_BRUNETON_RAYS_OF_TEXELS_GLSL
#define AUREOLE_BRUNETON_RAYS_OF_TEXELS_GLSL

CONST(bool, SINGLE_SCATTERING, true)
SPEC_INT(8, RAY_NODES, 6)
SPEC_BOOL(32, PUBLISHED_STEPS, false)
IMAGE_3D(6, scattering_out)

#define AUREOLE_OWN_SCATTERED_DIFFUSE
#include "models/bruneton/bruneton_march.glsl"
#include "models/bruneton/slices.glsl"

void scattering_texel(ivec3 id) {
    ivec3 size = imageSize(scattering_out);
    int heights = size.z / scattering_layers();
    int z = first_slice() + id.z;
    if (id.x >= size.x || id.y >= size.y || z >= heights) return;
    Ray ray = table_ray(ivec3(id.x, id.y, z), ivec3(size.x, size.y, heights));
    RayLight light = no_light();
    if (PUBLISHED_STEPS) light = march_even(ray);
    else light = march(ray);

    vec3 first = light.multiple / rayleigh_phase(ray.nu);  // `multiple` has the table's scale already
    vec3 most = vec3(LARGEST_STORED);
    real sharp_red = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        vec3 single = TABLE_SCALE * light.single[c];
        if (!phase_is_sharp(c)) {
            first += single;
        } else if (COMBINED) {
            sharp_red = single.x;
        } else {
            imageStore(scattering_out, ivec3(id.x, id.y, z + sharp_layer(c) * heights), vec4(min(single, most), real(0)));
        }
    }
    imageStore(scattering_out, ivec3(id.x, id.y, z), vec4(min(first, most), sharp_red));
}

#endif
