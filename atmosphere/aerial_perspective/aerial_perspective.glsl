// Aerial perspective: what the air between the camera and a point adds and takes, in a volume of froxels over the screen and
// distance. RGB optical depth, so that far hills turn the right colour. Layers stacked in y:
//   layer 0:                          optical depth to the distance of the slice;
//   layer 1 + sun * sky_view_layers(): in-scattered radiance as in layer 0 of the sky-view table, then its sharp phases.
// Axes: screen x and y with the outer texels on the screen's edges; slice k of n at the distance last (k / (n - 1))^2, from 0 at the
// camera; between slices look-ups are linear in distance, as what the air adds and takes nearly is.
#ifndef AUREOLE_AERIAL_PERSPECTIVE_GLSL
#define AUREOLE_AERIAL_PERSPECTIVE_GLSL

#include "aerial_perspective/air_before.glsl"
#include "aerial_perspective/slices.glsl"
#include "sky_view/sky_view.glsl"

int froxel_layers() { return 1 + SUN_COUNT * sky_view_layers(); }

#ifdef AUREOLE_AERIAL_PERSPECTIVE_TABLE
vec3 froxel_layer(vec3 position, int layer, ivec3 size, int rows) {
    real row = real(layer * rows) + real(0.5) + clamp_within_layer(position.y * real(rows - 1), rows);
    return vec3(SAMPLE(aerial_perspective_table,
                       vec3(unit_to_texture(position.x, size.x), row / real(size.y), unit_to_texture(position.z, size.z))));
}

// A kernel that runs once for every three of N wavelengths has included common/triplet.glsl.
#ifndef AUREOLE_IN_RGB
#define AUREOLE_IN_RGB(light) light
#endif

// (x, y) of the target in [0, 1]^2; distance in the air, km; direction in world axes. Beyond the last slice: as there.
AerialPerspective froxel_aerial_perspective(real x, real y, real distance_km, vec3 direction) {
    ivec3 size = textureSize(aerial_perspective_table, 0);
    int rows = size.y / froxel_layers();
    vec3 position = vec3(clamp(x, real(0), real(1)), clamp(y, real(0), real(1)),
                         slice_position(clamp(distance_km * view.froxels.y, real(0), real(1)), size.z));
    AerialPerspective result;
    result.transmittance = AUREOLE_IN_RGB(exp(-froxel_layer(position, 0, size, rows)));
    result.radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        int base = 1 + sun * sky_view_layers();
        vec3 radiance = froxel_layer(position, base, size, rows);
        real nu = dot(direction, vec3(view.sun_direction[sun]));
        for (int c = 0; c < PHASE_COUNT; ++c)
            if (phase_is_sharp(c)) radiance += froxel_layer(position, base + sharp_layer(c), size, rows) * phase_value(c, nu);
        result.radiance += AUREOLE_IN_RGB(radiance) * (view.table_exposure_inverse[sun] * vec3(view.sun_irradiance[sun]));
    }
    return result;
}
#endif

#endif
