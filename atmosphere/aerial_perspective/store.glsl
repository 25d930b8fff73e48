// Writes a froxel: all layers of one sun (aerial_perspective.glsl). Needs `view`, `froxels_out`.
#ifndef AUREOLE_AERIAL_PERSPECTIVE_STORE_GLSL
#define AUREOLE_AERIAL_PERSPECTIVE_STORE_GLSL

#include "common/storage.glsl"

void store_layer(ivec3 froxel, int rows, int layer, vec3 value) {
    imageStore(froxels_out, ivec3(froxel.x, froxel.y + layer * rows, froxel.z), vec4(storable(value), real(0)));
}

void store_froxel(ivec3 froxel, int rows, int sun, vec3 depth, vec3 radiance, vec3 single[MAX_PHASES]) {
    int layer = 1 + sun * sky_view_layers();
    if (sun == 0) store_layer(froxel, rows, 0, depth);
    store_layer(froxel, rows, layer, radiance * view.table_exposure[sun]);
    for (int c = 0; c < PHASE_COUNT; ++c)
        if (phase_is_sharp(c)) store_layer(froxel, rows, layer + sharp_layer(c), single[c] * view.table_exposure[sun]);
}

#endif
