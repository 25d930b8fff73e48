// The ray march of Hillaire, EGSR 2020, as published: uniform steps, the medium sampled at the end of each step (3/10 into its
// cell), constant within it; no cuts. RayLight march(Ray) as in common/march.glsl, for comparison.
#ifndef AUREOLE_MARCH_UNIFORM_GLSL
#define AUREOLE_MARCH_UNIFORM_GLSL

#include "common/geometry.glsl"
#include "common/slab.glsl"
#include "medium/medium.glsl"
#include "multi_scatter/multi_scatter.glsl"
#include "transmittance/transmittance.glsl"

struct RayLight {
    vec3 single[MAX_PHASES];
    vec3 multiple;
    vec3 depth;
};

RayLight march_uniform(Ray ray, int steps) {
    RayLight light;
    light.multiple = vec3(real(0));
    light.depth = vec3(real(0));
    for (int c = 0; c < MAX_PHASES; ++c) light.single[c] = vec3(real(0));
    real before = real(0);
    for (int i = 0; i < steps; ++i) {
        real t = ray.end * (real(i) + real(0.3)) / real(steps);
        real step_km = t - before;
        before = t;
        real h = altitude_after(ray.altitude, ray.mu, t);
        real mu_s = sun_mu_after(ray, t, h);
        Medium air = sample_medium(h);
        vec3 slab = air.extinction * step_km;
        vec3 weight = exp(-light.depth) * mean_transmittance(slab) * step_km;
        vec3 beam = weight * transmittance_to_sun(h, mu_s);
        for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += beam * air.scattering[c];
        light.multiple += weight * scattered_diffuse(h, view_mu_after(ray, t, h), mu_s, ray.nu, air.scattering);
        light.depth += slab;
    }
    return light;
}

#endif
