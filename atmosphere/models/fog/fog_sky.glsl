// The functions that composite/composite.glsl asks of a model, by fog.
#ifndef AUREOLE_FOG_SKY_GLSL
#define AUREOLE_FOG_SKY_GLSL

#include "models/fog/fog.glsl"

vec3 sky_radiance(vec3 direction, ViewDirection v, vec3 beyond) {
    Medium air = sample_medium(view.camera.x);
    vec3 radiance = vec3(real(0));
    Ray ray;
    int sun = 0;
    do {  // tested at the end: see march.glsl
        ray = camera_ray_towards(v.mu, v.sine, dot(v.horizontal, vec3(view.sun_azimuth[sun])), sun);
        real nu = dot(direction, vec3(view.sun_direction[sun]));
        radiance += vec3(view.sun_irradiance[sun]) * fog_sky_radiance(air, ray, sun, nu);
        ++sun;
    } while (sun < SUN_COUNT);
    if ((SUN_DISK || SCENE_COLOR) && !ray.ground) radiance += beyond * in_rgb(exp(-fog_extinction(air) * fog_length(ray)));
    return radiance;
}

AerialPerspective aerial_perspective(real /*x*/, real /*y*/, real distance_km, vec3 direction) {
    Medium air = sample_medium(view.camera.x);
    AerialPerspective result;
    result.transmittance = in_rgb(exp(-fog_extinction(air) * distance_km));
    result.radiance = vec3(real(0));
    vec3 source = vec3(real(0));
    int sun = 0;
    do {
        real nu = dot(direction, vec3(view.sun_direction[sun]));
        vec3 irradiance = vec3(view.sun_irradiance[sun]);
        if (IN_TRIPLETS) result.radiance += irradiance * fog_sent(air, sun, nu, distance_km);
        else source += irradiance * fog_source(air, sun, nu);
        ++sun;
    } while (sun < SUN_COUNT);
    if (!IN_TRIPLETS) result.radiance = fog_radiance(air, source, distance_km);
    return result;
}

#endif
