// View table: what a camera in the air sees in every direction, of every sun. There all rays start at one altitude under one zenith angle of
// a sun, and two of the four axes of the 4D table are left. The interpolation of the 4D table is linear along each, so that its nodes are
// enough: x: nu, y: rows of mu as in the 4D table (bruneton.glsl). Layers stacked along y, those of a sun one after another: as the 4D
// table's, but the first has the ground's light added, over p_R(nu). That light goes by the sun's zenith cosine at the end of the ray, which
// is linear in nu, but has more detail: for its sake the steps of nu are split (view.cpp).
// Beside it a strip of optical depths to the top from the camera's altitude, with the nodes in x of the transmittance table.
//
// Rays of a camera in space start under another zenith angle of the sun each, and are looked up in the 4D table.
#ifndef AUREOLE_BRUNETON_VIEW_TABLE_GLSL
#define AUREOLE_BRUNETON_VIEW_TABLE_GLSL

#include "models/bruneton/bruneton.glsl"
#include "sky_view/sky_view.glsl"

int view_table_rows(int height) { return height / (SUN_COUNT * scattering_layers_apart()); }

#ifdef AUREOLE_VIEW_TABLE
// Per unit of the irradiance of a sun, 1/sr, with the ground's light; `position`: mu_position at the camera's altitude.
vec3 view_table_radiance(int sun, real position, bool ground, real nu) {
    ivec2 size = textureSize(view_table, 0);
    int layers = scattering_layers_apart();
    int rows = view_table_rows(size.y);
    real row = clamp_within_layer(row_at(position, ground, rows), rows);
    vec2 at = vec2(unit_to_texture(real(0.5) * (nu + 1), size.x), (real(0.5) + row + real(sun * layers * rows)) / real(size.y));
    vec3 radiance = rayleigh_phase(nu) * vec3(SAMPLE(view_table, at));
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c))
            radiance += AUREOLE_SHARP_PHASE(c, nu) *
                        vec3(SAMPLE(view_table, vec2(at.x, at.y + real(sharp_layer(c)) / real(SUN_COUNT * layers))));
    return radiance / TABLE_SCALE;
}

// Of a direction above the horizon.
vec3 view_table_transmittance(real position) {
    int nodes = textureSize(view_depth_table, 0).x;
    real x = position * real(nodes - 1);
    int node = min(int(x), nodes - 2);
    return exp(-mix(vec3(texelFetch(view_depth_table, ivec2(node, 0), 0)), vec3(texelFetch(view_depth_table, ivec2(node + 1, 0), 0)), x - real(node)));
}
#endif

#endif
