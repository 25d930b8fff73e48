// The function that light/light.glsl asks of a model, by single scattering.
#ifndef AUREOLE_SINGLE_LIGHT_GLSL
#define AUREOLE_SINGLE_LIGHT_GLSL

#define AUREOLE_SINGLE_PHASE(c, nu) smooth_phase(c, nu)
#include "models/single/single.glsl"

vec3 smooth_sky_radiance(int sun, real mu, real sine, real azimuth_cosine, real nu) {
    Ray ray = camera_ray_towards(mu, sine, azimuth_cosine, sun);
    RayLight light = march_single(ray);
    return in_rgb(scattered_once(light, nu) + ground_once(ray, light));
}

#endif
