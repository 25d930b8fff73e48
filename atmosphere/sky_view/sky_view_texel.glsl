// One texel of the sky-view table, whichever way the ray is marched: needs sky_view.glsl and RayLight march(Ray), or another
// function that AUREOLE_SKY_VIEW_MARCH names.
#ifndef AUREOLE_SKY_VIEW_TEXEL_GLSL
#define AUREOLE_SKY_VIEW_TEXEL_GLSL

#include "common/ground.glsl"
#include "common/storage.glsl"
#include "sky_view/camera_ray.glsl"

#ifndef AUREOLE_SKY_VIEW_MARCH
#define AUREOLE_SKY_VIEW_MARCH march
#endif

// What lights the ground: the sun's beam and, where a kernel that defines AUREOLE_SKY_LIGHTS_GROUND knows multiple scattering, the sky.
vec3 ground_irradiance(real mu_s) {
    vec3 irradiance = ground_beam_irradiance(mu_s);
#ifdef AUREOLE_SKY_LIGHTS_GROUND
    if (MULTIPLE_SCATTERING) irradiance += ground_diffuse_irradiance(mu_s);
#endif
    return irradiance;
}

void sky_view_texel(ivec2 id) {
    ivec2 size = imageSize(sky_view_out);
    int rows = size.y / sky_view_all_layers();
    int sun = id.y / rows;
    if (id.x >= size.x || sun >= SUN_COUNT) return;
    int row = id.y % rows;
    int half_rows = rows / 2;
    bool below = row < half_rows;
    real position = texel_to_unit(below ? row : row - half_rows, half_rows);
    real half_sine = sky_view_half_sine(position, below);

    Ray ray = camera_ray(half_sine, below, sky_view_azimuth_cosine(texel_to_unit(id.x, size.x)), sun);
    // The limb of the top has no air: a rounding of its altitude is metres of it, and the next row a thousandth of those behind them.
    if (view.camera.w > real(0.5) && row == rows - 1) ray.end = real(0);
    RayLight light = AUREOLE_SKY_VIEW_MARCH(ray);
    vec3 radiance = light.multiple;
    if (below) {
        real ground_mu_s = sun_mu_after(ray, ray.end, real(0));
        radiance += ground_radiance(light.depth, ground_irradiance(ground_mu_s));
    }
    real exposure = view.table_exposure[sun];
    int base = sun * sky_view_layers() * rows + row;
    for (int c = 0; c < PHASE_COUNT; ++c) {
        if (phase_is_sharp(c))
            imageStore(sky_view_out, ivec2(id.x, base + sharp_layer(c) * rows), vec4(storable(light.single[c] * exposure), real(0)));
        else
            radiance += light.single[c] * phase_value(c, ray.nu);
    }
    imageStore(sky_view_out, ivec2(id.x, base), vec4(storable(radiance * exposure), real(0)));
    if (sun == 0) imageStore(sky_view_out, ivec2(id.x, SUN_COUNT * sky_view_layers() * rows + row), vec4(storable(light.depth), real(0)));
}

#endif
