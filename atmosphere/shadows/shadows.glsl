// What the shadows of a sun take from the air: single scattering that its direct beam would have given, in a volume over the screen and
// distance like that of aerial perspective (aerial_perspective.glsl), per unit of the sun's irradiance.
// Layers stacked in y: layer 0 by smooth phase functions, then a layer for each sharp one, without its value. Slices side by side in
// x. Slice 0, at the camera, is 0; the last one holds what the sky loses.
#ifndef AUREOLE_SHADOWS_GLSL
#define AUREOLE_SHADOWS_GLSL

#include "aerial_perspective/slices.glsl"
#include "sky_view/sky_view.glsl"

SPEC_INT(39, SHADOW_SLICES, 2)

int shadowed_sun() { return int(view.froxels.w); }

#ifdef AUREOLE_SHADOW_TABLE
vec3 shadow_texel(vec2 at, int slice, int layer) {
    ivec2 size = textureSize(shadow_table, 0);
    int columns = size.x / SHADOW_SLICES;
    int rows = size.y / sky_view_layers();
    real column = real(slice * columns) + real(0.5) + clamp_within_layer(at.x * real(columns - 1), columns);
    real row = real(layer * rows) + real(0.5) + clamp_within_layer(at.y * real(rows - 1), rows);
    return vec3(SAMPLE(shadow_table, vec2(column / real(size.x), row / real(size.y))));
}

// Radiance that the air up to a distance lacks, times the sun's irradiance; distance in the air, km; negative: as far as the air goes.
vec3 shadow_loss(real x, real y, real distance_km, vec3 direction) {
    real share = distance_km < 0 ? real(1) : min(distance_km * view.froxels.z, real(1));
    real position = slice_position(share, SHADOW_SLICES) * real(SHADOW_SLICES - 1);
    int slice = min(int(position), SHADOW_SLICES - 2);
    real between = position - real(slice);
    vec2 at = vec2(clamp(x, real(0), real(1)), clamp(y, real(0), real(1)));
    int sun = shadowed_sun();
    real nu = dot(direction, vec3(view.sun_direction[sun]));
    vec3 loss = mix(shadow_texel(at, slice, 0), shadow_texel(at, slice + 1, 0), between);
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c))
            loss += mix(shadow_texel(at, slice, sharp_layer(c)), shadow_texel(at, slice + 1, sharp_layer(c)), between) * phase_value(c, nu);
    return loss * (view.table_exposure_inverse[sun] * vec3(view.sun_irradiance[sun]));
}
#endif

#endif
