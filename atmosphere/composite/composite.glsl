// The composite: what a pixel shows. Sky and bare ground from the sky-view table; the sun's disk; the host's geometry seen
// through the air in front of it. Then, if asked for, exposure, tone map, the sRGB curve and dither, in this order.
#ifndef AUREOLE_COMPOSITE_GLSL
#define AUREOLE_COMPOSITE_GLSL

#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_AERIAL_PERSPECTIVE_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, ViewBlock, view)
SAMPLER_2D(2, sky_view_table)
SAMPLER_3D(4, aerial_perspective_table)
SAMPLER_2D(5, scene_color)
SAMPLER_2D(6, scene_depth)
SAMPLER_2D(8, directions)

SPEC_BOOL(16, SCENE_COLOR, false)
SPEC_BOOL(17, SCENE_DEPTH, false)
SPEC_BOOL(18, AERIAL_PERSPECTIVE, false)
SPEC_BOOL(19, SUN_DISK, true)
SPEC_INT(20, TONE_MAP, 0)  // 0 none, 1 ACES as fitted by Hill
SPEC_BOOL(21, ENCODE_SRGB, false)
SPEC_BOOL(22, DITHER, false)
SPEC_BOOL(23, GIVEN_DIRECTIONS, false)

struct CompositeTarget {
    vec4 size;  // x, y: width and height of the target; z: frame number, for the dither
};
PUSH_CONSTANTS(CompositeTarget, target)

#include "common/view_ray.glsl"
#include "transmittance/transmittance.glsl"
#include "sky_view/sky_view.glsl"
#include "aerial_perspective/aerial_perspective.glsl"
#include "composite/display.glsl"

// The disk of a sun where the view direction meets it, limb-darkened, before the air.
vec3 disk_radiance(int sun, vec3 direction) {
    vec3 apart = direction - vec3(view.sun_direction[sun]);
    real chord = dot(apart, apart);
    real mu = sqrt(max(1 - chord * view.sun_disk[sun].w, real(1e-6)));
    vec3 limb = pow(vec3(mu), vec3(view.sun_limb[sun]));
    return chord < view.sun_limb[sun].w ? vec3(view.sun_disk[sun]) * limb : vec3(real(0));
}

// Sky and bare ground, with `beyond` (stars, say) behind the air.
vec3 sky(vec3 direction, ViewDirection v, vec3 beyond) {
    vec3 radiance = vec3(real(0));
    vec3 coordinates;
    int sun = 0;
    do {  // tested at the end: see march.glsl
        coordinates = sky_view_coordinates(sun, v.mu, v.sine, dot(v.horizontal, vec3(view.sun_azimuth[sun])));
        vec3 irradiance = vec3(view.sun_irradiance[sun]);
        radiance += irradiance * sky_view_radiance(coordinates, dot(direction, vec3(view.sun_direction[sun])));
        if (SUN_DISK) beyond += irradiance * disk_radiance(sun, direction);
        ++sun;
    } while (sun < SUN_COUNT);
    if ((SUN_DISK || SCENE_COLOR) && sine_above_horizon(v) >= 0) radiance += beyond * sky_view_transmittance(coordinates);
    return radiance;
}

// Scene-linear radiance of a pixel.
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

    real distance_km = real(-1);  // nothing there
    if (SCENE_DEPTH) {
        real d = texelFetch(scene_depth, pixel, 0).x;
        real divisor = view.depth.z * d + view.depth.w;
        real depth = (view.depth.x * d + view.depth.y) / divisor;
        // The far end of the depth range is nothing; at infinity the divisor vanishes; 1e7 km is beyond any geometry.
        if (d != view.composite.z && abs(divisor) > real(1e-12) && depth > 0 && depth < real(1e7)) distance_km = depth * ray.stretch;
    }
    if (distance_km < 0) {
        return sky(ray.direction, v, color);
    }
    if (!AERIAL_PERSPECTIVE) return color;
    real entry = distance_to_air(v);
    if (entry < 0 || distance_km < entry) return color;
    AerialPerspective air = aerial_perspective(x, y, distance_km - entry, ray.direction);
    return color * air.transmittance + air.radiance;
}

vec4 composite_pixel(ivec2 pixel) {
    return vec4(display(pixel_radiance(pixel) * view.composite.x, pixel, target.size.z), real(1));
}

#endif
