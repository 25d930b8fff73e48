// The ray march of Hillaire, EGSR 2020, as published: uniform steps, the medium sampled at the end of each step, constant within
// it; no cuts. For comparison with common/march.glsl. Without a multi-scatter table the light that is scattered more than once is
// that of a field of radiance 1 from everywhere: the share of light that scattering hands on.
#ifndef AUREOLE_MARCH_UNIFORM_GLSL
#define AUREOLE_MARCH_UNIFORM_GLSL

#include "common/geometry.glsl"
#include "common/ray_light.glsl"
#include "common/slab.glsl"
#include "medium/medium.glsl"
#include "multi_scatter/multi_scatter.glsl"
#include "published_2020/uniform_steps.glsl"
#include "transmittance/transmittance.glsl"

RayLight march_uniform(Ray ray, int steps) {
    RayLight light = no_light();
    real before = real(0);
    for (int i = 0; i < steps; ++i) {
        real t = uniform_step_end(ray.end, i, steps);
        real step_km = t - before;
        before = t;
        real h = altitude_after(ray.altitude, ray.mu, t);
        real mu_s = sun_mu_after(ray, t, h);
        Medium air = sample_medium(h);
        vec3 slab = air.extinction * step_km;
        vec3 weight = exp(-light.depth) * mean_transmittance(slab) * step_km;
        vec3 beam = weight * transmittance_to_sun(h, mu_s);
        for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += beam * air.scattering[c];
#ifdef AUREOLE_MULTI_SCATTER_TABLE
        light.multiple += weight * scattered_diffuse(h, view_mu_after(ray, t, h), mu_s, ray.nu, air.scattering);
#else
        for (int c = 0; c < PHASE_COUNT; ++c) light.multiple += weight * air.scattering[c];
#endif
        light.depth += slab;
    }
    return light;
}

#endif
