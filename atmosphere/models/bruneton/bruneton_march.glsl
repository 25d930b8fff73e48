// The published integration along a ray: even steps by the trapezoidal rule, the transmittance to each from the table
// (Bruneton 2017, sections "single scattering" and "multiple scattering"). What march() of common/march.glsl does with Gauss nodes.
#ifndef AUREOLE_BRUNETON_MARCH_GLSL
#define AUREOLE_BRUNETON_MARCH_GLSL

#include "common/march.glsl"

SPEC_INT(33, RAY_STEPS, 50)

// The share of the sun's disk above the horizon, as published: a smooth step in the cosine, over a disk of the sun's usual size.
CONST(real, PUBLISHED_SUN_RADIUS, real(0.004675))  // rad
real sun_share_even(real altitude, real mu_s) {
    real edge = PUBLISHED_SUN_RADIUS * bottom_radius() / (bottom_radius() + altitude);
    real x = clamp(real(0.5) + real(0.5) * (mu_s - horizon_mu(altitude)) / edge, real(0), real(1));
    return x * x * (3 - 2 * x);
}

RayLight march_even(Ray ray) {
    RayLight light = no_light();
    real step_km = ray.end / real(RAY_STEPS);
    int i = 0;
    do {  // tested at the end: see march.glsl
        real t = real(i) * step_km;
        real weight = i == 0 || i == RAY_STEPS ? real(0.5) * step_km : step_km;
        real h = altitude_after(ray.altitude, ray.mu, t);
        real mu_s = sun_mu_after(ray, t, h);
        Medium air = sample_medium(h);
        light.depth = dark_depth(ray, real(0), t, !ray.ground);
        vec3 reach = weight * exp(-light.depth);
        if (SINGLE_SCATTERING) {
            vec3 beam = reach * (sun_share_even(h, mu_s) * transmittance_to_top(h, mu_s));
            for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += beam * air.scattering[c];
        }
        if (MULTIPLE_SCATTERING)
            light.multiple += reach * scattered_diffuse(h, view_mu_after(ray, t, h), mu_s, ray.nu, air.scattering);
        ++i;
    } while (i <= RAY_STEPS);
    return light;
}

#endif
