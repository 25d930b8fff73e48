// What comes along a ray: scattered light, and the ground's. Needs `atm` and the tables of scattering, transmittance, irradiance.
#ifndef AUREOLE_BRUNETON_RAYS_GLSL
#define AUREOLE_BRUNETON_RAYS_GLSL

#include "common/dark_depth.glsl"
#include "common/ground.glsl"
#include "models/bruneton/bruneton.glsl"

real nu_of(real mu, real mu_s, real azimuth_cosine) {
    real sines = sqrt(max((1 - mu) * (1 + mu) * (1 - mu_s) * (1 + mu_s), real(0)));
    return clamp(mu * mu_s + sines * azimuth_cosine, real(-1), real(1));
}

#ifdef AUREOLE_IRRADIANCE_TABLE
// Radiance that the ground at the end of a ray sends through the air before it, 1/sr. The altitude there is 0, which the ray's length
// gives to some metres only where the shell is as thick as the planet.
vec3 ray_ground_radiance(Ray ray) {
    vec3 depth = optical_depth_to_top(real(0), -view_mu_after(ray, ray.end, real(0))) - optical_depth_to_top(ray.altitude, -ray.mu);
    return ground_radiance(max(depth, vec3(real(0))), ground_irradiance(sun_mu_after(ray, ray.end, real(0))));
}

// Per unit of solar irradiance, 1/sr.
vec3 ray_radiance(Ray ray) {
    vec3 radiance = air_radiance(scattering_place(ray), ray.nu);
    if (ray.ground) radiance += ray_ground_radiance(ray);
    return radiance;
}
#endif

#endif
