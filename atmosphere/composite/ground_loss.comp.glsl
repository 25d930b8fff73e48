// What shadows take from bare ground, by pixel: for composites whose light of N wavelengths is in tables that are added up. Run once
// a triplet with its air, before the composite, which subtracts the sum (GROUND_LOSS_GIVEN). Models with a transmittance table.
#include "composite/inputs.glsl"
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(2, transmittance_table)
IMAGE_2D(9, target_out)
#include "common/geometry.glsl"
#include "transmittance/transmittance.glsl"
#include "composite/scene_distance.glsl"
#include "shadows/ground.glsl"

LOCAL_SIZE(8, 8, 1)

COMPUTE_MAIN(id) {
    if (real(id.x) >= target.size.x || real(id.y) >= target.size.y) return;
    ivec2 pixel = ivec2(id.x, id.y);
    ViewRay ray = view_ray((real(id.x) + real(0.5)) / target.size.x, (real(id.y) + real(0.5)) / target.size.y);
    vec3 loss = vec3(real(0));
    if (ray.valid && scene_distance(pixel, ray) < 0) loss = ground_shadow_loss(ray.direction, view_direction(ray.direction));
    if (!first_triplet()) loss += vec3(texelFetch(sum_before, pixel, 0));
    imageStore(target_out, pixel, vec4(loss, real(0)));
}
