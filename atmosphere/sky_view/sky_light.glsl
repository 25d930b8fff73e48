// The functions that composite/composite.glsl asks of a model, by sky-view table and froxels.
#ifndef AUREOLE_SKY_LIGHT_GLSL
#define AUREOLE_SKY_LIGHT_GLSL

#define AUREOLE_SKY_VIEW_TABLE
#define AUREOLE_AERIAL_PERSPECTIVE_TABLE
#define AUREOLE_TRANSMITTANCE_TABLE
SAMPLER_2D(2, sky_view_table)
SAMPLER_2D(3, transmittance_table)
SAMPLER_3D(4, aerial_perspective_table)

#include "transmittance/transmittance.glsl"
#include "sky_view/sky_view.glsl"
#include "aerial_perspective/aerial_perspective.glsl"

vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond) {
    vec3 radiance = vec3(real(0));
    vec3 coordinates;
    int sun = 0;
    do {  // tested at the end: see march.glsl
        coordinates = sky_view_coordinates(sun, v.mu, v.sine, dot(v.horizontal, vec3(view.sun_azimuth[sun])));
        radiance += sunlit(sun, sky_view_radiance(coordinates, dot(direction, vec3(view.sun_direction[sun]))));
        ++sun;
    } while (sun < SUN_COUNT);
    if ((SUN_DISK || SCENE_COLOR) && sine_above_horizon(v) >= 0) radiance += beyond * in_rgb(sky_view_transmittance(coordinates));
    return radiance;
}

AerialPerspective aerial_perspective(real x, real y, real distance_km, vec3 direction) {
    return froxel_aerial_perspective(x, y, distance_km, direction);
}

#endif
