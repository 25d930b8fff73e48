// The composite: what a pixel shows. Sky and bare ground as the model has them; the sun's disk; the host's geometry seen through the
// air in front of it. Then, if asked for, exposure, tone map, the sRGB curve and dither, in this order.
//
// The including kernel has included composite/inputs.glsl and the model's own functions:
//   vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond): sky and bare ground, with `beyond` (stars, disks) behind the air,
//     which matters only if SUN_DISK or SCENE_COLOR;
//   AerialPerspective aerial_perspective(real x, real y, real distance_km, vec3 direction): of the air up to a distance in it.
// Both in RGB: what the air sends and lets through has gone through in_rgb (triplet.glsl), unless all of it comes from tables.
#ifndef AUREOLE_COMPOSITE_GLSL
#define AUREOLE_COMPOSITE_GLSL

#include "common/storage.glsl"
#include "composite/display.glsl"
#include "composite/scene_distance.glsl"
#include "phase/phase.glsl"
#define AUREOLE_SHADOW_TABLE
#include "shadows/shadows.glsl"
#ifdef AUREOLE_OPTICAL_DEPTH_TO_TOP
#include "shadows/ground.glsl"
#else
vec3 ground_shadow_loss(vec3, ViewDirection) { return vec3(real(0)); }  // a model that knows no beam of the sun
#endif

// A model whose sky differs from pixel to pixel in more than direction says otherwise.
#ifndef AUREOLE_SKY_RADIANCE
#define AUREOLE_SKY_RADIANCE(pixel, direction, v, beyond) sky_radiance(direction, v, beyond)
#endif

// A sun per unit of its irradiance, before the air: its disk where the view direction meets it, limb-darkened; or a lobe of
// Henyey & Greenstein around it, whose integral over the sphere is 1 too.
vec3 disk_radiance(int sun, vec3 direction) {
    vec3 apart = direction - vec3(view.sun_direction[sun]);
    real chord = dot(apart, apart);
    if (SUN_LOBE) return vec3(view.sun_limb[sun].w > 0 ? henyey_greenstein_lobe(view.composite.y, chord) : real(0));
    real mu = sqrt(max(1 - chord * view.sun_disk[sun].w, real(1e-6)));
    vec3 limb = pow(vec3(mu), vec3(view.sun_limb[sun]));
    return chord < view.sun_limb[sun].w ? vec3(view.sun_disk[sun]) * limb : vec3(real(0));
}

// All suns, before the air.
vec3 disks(vec3 direction) {
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) radiance += vec3(view.sun_irradiance[sun]) * disk_radiance(sun, direction);
    return radiance;
}

// Light without what shadows take of it. Parts of light may be negative, and colours out of gamut; their sum is not shown so.
vec3 without(vec3 light, vec3 loss) {
    return IN_TRIPLETS || NO_NEGATIVE ? light - loss : max(light - loss, vec3(real(0)));
}

// What shadows take from the sky and bare ground of a pixel: of the air in the table of all triplets, of the ground by each.
vec3 sky_loss(ivec2 pixel, real x, real y, vec3 direction, ViewDirection v) {
    vec3 ground = GROUND_LOSS_GIVEN ? vec3(texelFetch(sum_before, pixel, 0)) : ground_shadow_loss(direction, v);
    return whole(shadow_loss(x, y, real(-1), direction)) + ground;
}

// Scene-linear radiance of a pixel; of N wavelengths the part of three.
vec3 pixel_radiance(ivec2 pixel) {
    real x = (real(pixel.x) + real(0.5)) / target.size.x;
    real y = (real(pixel.y) + real(0.5)) / target.size.y;
    ViewRay ray = view_ray(x, y);
    if (GIVEN_DIRECTIONS) {
        vec3 given = vec3(texelFetch(directions, pixel, 0));
        real length_squared = dot(given, given);
        ray.direction = given / sqrt(max(length_squared, real(1e-30)));
        ray.valid = length_squared > real(1e-30);  // (0, 0, 0) is no direction: black
    }
    if (!ray.valid) return vec3(real(0));
    ViewDirection v = view_direction(ray.direction);
    vec3 color = SCENE_COLOR ? vec3(texelFetch(scene_color, pixel, 0)) : vec3(real(0));

    real distance_km = scene_distance(pixel, ray);
    if (distance_km < 0) {
        if (SUN_DISK) color += disks(ray.direction);
        color = AUREOLE_SKY_RADIANCE(pixel, ray.direction, v, color);
        if (SHADOWS) color = without(color, sky_loss(pixel, x, y, ray.direction, v));
        return color;
    }
    if (!AERIAL_PERSPECTIVE) return whole(color);
    real entry = distance_to_air(v);
    if (entry < 0 || distance_km < entry) return whole(color);
    AerialPerspective air = aerial_perspective(x, y, distance_km - entry, ray.direction);
    if (SHADOWS) air.radiance = without(air.radiance, whole(shadow_loss(x, y, distance_km - entry, ray.direction)));
    return color * air.transmittance + air.radiance;
}

vec4 composite_pixel(ivec2 pixel) {
    vec3 radiance = pixel_radiance(pixel);
    if (!first_triplet()) radiance += vec3(texelFetch(sum_before, pixel, 0));
    if (!last_triplet()) return vec4(radiance, real(0));
    if (NO_NEGATIVE || IN_TRIPLETS) radiance = max(radiance, vec3(real(0)));
    return vec4(storable(display(radiance * view.composite.x, TONE_MAP, ENCODE_SRGB, DITHER, pixel, target.size.z)), real(1));
}

#endif
