// Single scattering (Nishita 1993): light that the air has turned once, from the sun's beam into the view ray. With p_c the phase
// functions and b_c the scattering coefficients that go with them,
//   L = E sum_c p_c(nu) integral b_c(h_t) T(camera, t) T(t, sun) V(t, sun) dt  +  ground,
// T transmittances, V = 0 in the planet's shadow; where the ray ends on the ground, ground = T albedo / pi E mu_s T(ground, sun).
//
// Two ways to step: Gauss nodes on the sunlit pieces of the ray (common/march.glsl), or the midpoints of uniform steps, as in the
// papers. Whence T(t, sun) comes is the including kernel's: nested.glsl, or the transmittance table. Needs `atm`, `view`.
#ifndef AUREOLE_SINGLE_GLSL
#define AUREOLE_SINGLE_GLSL

#include "models/single/inputs.glsl"
#include "common/ground.glsl"
#include "common/march.glsl"
#include "phase/phase.glsl"
#include "sky_view/camera_ray.glsl"

// The air of a step counts as that at its middle, and the light as if all of it were scattered there.
RayLight march_midpoints(Ray ray) {
    RayLight light = no_light();
    real step_km = ray.end / real(VIEW_MIDPOINTS);
    for (int i = 0; i < VIEW_MIDPOINTS; ++i) {
        real t = (real(i) + real(0.5)) * step_km;
        real h = altitude_after(ray.altitude, ray.mu, t);
        Medium air = sample_medium(h);
        vec3 half_depth = air.extinction * (real(0.5) * step_km);
        vec3 beam = exp(-(light.depth + half_depth)) * transmittance_to_sun(h, sun_mu_after(ray, t, h)) * step_km;
        for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += beam * air.scattering[c];
        light.depth += real(2) * half_depth;
    }
    return light;
}

RayLight march_single(Ray ray) {
    if (VIEW_MIDPOINTS > 0) return march_midpoints(ray);
    return march(ray);
}

// A kernel may take other values for the phase functions by defining AUREOLE_SINGLE_PHASE(c, nu).
#ifndef AUREOLE_SINGLE_PHASE
#define AUREOLE_SINGLE_PHASE(c, nu) phase_value(c, nu)
#endif
vec3 scattered_once(RayLight light, real nu) {
    vec3 radiance = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) radiance += light.single[c] * AUREOLE_SINGLE_PHASE(c, nu);
    return radiance;
}

// The ground at the end of a ray, lit by the sun's beam alone.
vec3 ground_once(Ray ray, RayLight light) {
    if (!ray.ground) return vec3(real(0));
    return ground_radiance(light.depth, ground_beam_irradiance(sun_mu_after(ray, ray.end, real(0))));
}

#endif
