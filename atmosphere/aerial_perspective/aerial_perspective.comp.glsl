// Fills the froxels: one invocation a column, marching once from the camera and writing every slice on its way.
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
SPEC_INT(8, SLICE_NODES, 1)
SPEC_BOOL(11, MULTIPLE_SCATTERING, true)  // false: multi_scatter_table is not read

#include "common/slab.glsl"
#include "common/view_ray.glsl"
#include "medium/medium.glsl"
#include "multi_scatter/multi_scatter.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "aerial_perspective/store.glsl"

LOCAL_SIZE(8, 8, 1)

// Columns of all suns side by side: each marches alone, the first also writes the optical depth.
COMPUTE_MAIN(id) {
    ivec3 size = imageSize(froxels_out);
    int rows = size.y / froxel_layers();
    int sun = id.y / rows;
    if (id.x >= size.x || sun >= SUN_COUNT) return;
    int row = id.y % rows;
    ViewRay pixel = view_ray(texel_to_unit(id.x, size.x), texel_to_unit(row, rows));
    ViewDirection direction = view_direction(pixel.direction);
    real entry = distance_to_air(direction);
    Ray ray = air_ray(direction, max(entry, real(0)), sun, dot(pixel.direction, vec3(view.sun_direction[sun])));
    real leave = entry < 0 ? real(0) : distance_to_top(ray.altitude, ray.mu);

    vec3 depth = vec3(real(0));
    vec3 radiance = vec3(real(0));
    vec3 single[MAX_PHASES];
    for (int c = 0; c < PHASE_COUNT; ++c) single[c] = vec3(real(0));
    real begin = real(0);
    for (int slice = 0; slice < size.z; ++slice) {
        real position = texel_to_unit(slice, size.z);
        real end = min(view.froxels.x * position * position, leave);
        real step_km = (end - begin) / real(SLICE_NODES);
        // A slab: extinction and source of its middle, integrated exactly for constant air, so that thick fog neither overshoots
        // nor loses light.
        int k = 0;
        do {  // tested at the end: see march.glsl
            real t = begin + (real(k) + real(0.5)) * step_km;
            real h = altitude_after(ray.altitude, ray.mu, t);
            real mu_s = sun_mu_after(ray, t, h);
            Medium air = sample_medium(h);
            vec3 slab = air.extinction * step_km;
            vec3 weight = exp(-depth) * mean_transmittance(slab) * step_km;
            vec3 beam = transmittance_to_sun(h, mu_s);
            vec3 source = vec3(real(0));
            if (MULTIPLE_SCATTERING) source = scattered_diffuse(h, view_mu_after(ray, t, h), mu_s, ray.nu, air.scattering);
            for (int c = 0; c < PHASE_COUNT; ++c) {
                vec3 scattered = beam * air.scattering[c];
                if (phase_is_sharp(c)) single[c] += weight * scattered;
                else source += scattered * phase_value(c, ray.nu);
            }
            radiance += weight * source;
            depth += slab;
            ++k;
        } while (k < SLICE_NODES);
        begin = end;

        store_froxel(ivec3(id.x, row, slice), rows, sun, depth, radiance, single);
    }
}
