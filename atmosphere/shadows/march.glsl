// Fills the volume of losses: one invocation a column, marching once from the camera and writing every slice on its way.
#ifndef AUREOLE_SHADOWS_MARCH_GLSL
#define AUREOLE_SHADOWS_MARCH_GLSL

#include "common/storage.glsl"
#include "common/view_ray.glsl"
#include "shadows/beam.glsl"
#include "shadows/shadows.glsl"
#include "shadows/visibility.glsl"

LOCAL_SIZE(8, 8, 1)

// Of N wavelengths the loss of three, and of the triplets before: in RGB, so that the table is one.
void store_loss(ivec2 texel, vec3 loss, int sun) {
    vec3 sum = in_rgb(loss) * view.table_exposure[sun];
    if (!first_triplet()) sum += vec3(texelFetch(sum_before, texel, 0));
    imageStore(shadows_out, texel, vec4(storable(sum), real(0)));
}

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(shadows_out);
    int columns = size.x / SHADOW_SLICES;
    int rows = size.y / sky_view_layers();
    if (id.x >= columns || id.y >= rows) return;
    int sun = shadowed_sun();
    ViewRay pixel = view_ray(texel_to_unit(id.x, columns), texel_to_unit(id.y, rows));
    ViewDirection direction = view_direction(pixel.direction);
    real entry = distance_to_air(direction);
    // Up to the ground: below it there is nothing to lose, and the sky's pixels show the ground.
    Ray ray = camera_air_ray(direction, entry, sun, dot(pixel.direction, vec3(view.sun_direction[sun])));

    vec3 depth = vec3(real(0));
    vec3 loss = vec3(real(0));
    vec3 sharp[MAX_PHASES];
    for (int c = 0; c < PHASE_COUNT; ++c) sharp[c] = vec3(real(0));
    real begin = real(0);
    for (int slice = 0; slice < SHADOW_SLICES; ++slice) {
        real position = texel_to_unit(slice, SHADOW_SLICES);
        real end = min(position * position / view.froxels.z, ray.end);
        real step_km = (end - begin) / real(SHADOW_SAMPLES);
        int k = 0;
        do {  // tested at the end: see common/march.glsl
            real t = begin + (real(k) + real(0.5)) * step_km;
            BeamSlab slab = beam_slab(ray, depth, t, step_km);
            vec3 dark = slab.beam * (1 - sun_visibility(pixel.direction * (max(entry, real(0)) + t)));
            for (int c = 0; c < PHASE_COUNT; ++c) {
                vec3 scattered = dark * slab.air.scattering[c];
                if (phase_is_sharp(c)) sharp[c] += scattered;
                else loss += scattered * phase_value(c, ray.nu);
            }
            depth += slab.depth;
            ++k;
        } while (k < SHADOW_SAMPLES);
        begin = end;

        ivec2 texel = ivec2(slice * columns + id.x, id.y);
        store_loss(texel, loss, sun);
        for (int c = 0; c < PHASE_COUNT; ++c)
            if (phase_is_sharp(c)) store_loss(ivec2(texel.x, texel.y + sharp_layer(c) * rows), sharp[c], sun);
    }
}

#endif
