// What shadows take from the bare ground that a sky's pixel shows. Needs what visibility.glsl, dark_depth.glsl and triplet.glsl
// need, and `view`.
#ifndef AUREOLE_SHADOWS_GROUND_GLSL
#define AUREOLE_SHADOWS_GROUND_GLSL

#include "common/dark_depth.glsl"
#include "common/ground.glsl"
#include "common/triplet.glsl"
#include "common/view_ray.glsl"
#include "shadows/shadows.glsl"
#include "shadows/visibility.glsl"

// Of the sun's beam alone: the sky's light on the ground stays. In RGB (in_rgb), of N wavelengths what three add.
vec3 ground_shadow_loss(vec3 direction, ViewDirection v) {
    real entry = distance_to_air(v);
    int sun = shadowed_sun();
    Ray ray = camera_air_ray(v, entry, sun, dot(direction, vec3(view.sun_direction[sun])));
    if (!ray.ground) return vec3(real(0));
    real dark = 1 - sun_visibility(direction * (max(entry, real(0)) + ray.end));
    // Of wavelengths per unit of the sun's: its colour is RGB.
    vec3 irradiance = IN_TRIPLETS ? vec3(real(1)) : vec3(view.sun_irradiance[sun]);
    irradiance *= ground_beam_irradiance(sun_mu_after(ray, ray.end, real(0)));
    vec3 loss = dark * ground_radiance(dark_depth(ray, real(0), ray.end, false), irradiance);
    return IN_TRIPLETS ? sunlit(sun, loss) : loss;
}

#endif
