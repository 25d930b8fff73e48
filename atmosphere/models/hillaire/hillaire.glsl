// The ray march and the multiple scattering of Hillaire, EGSR 2020, as published.
//
// March (section 5.3): steps.glsl; the medium is constant within a step, where the integral of the source S behind what has been
// passed is exact: exp(-tau) S (1 - exp(-sigma_t dt)) / sigma_t.
//
// Multiple scattering (section 5.5). Two assumptions, that light scatters evenly from the second order on and that the air around a
// point is lit as the point itself is, make the orders a geometric series:
//   L_2nd: radiance scattered once, with an isotropic phase, averaged over 64 directions (equation 5, the ground's light included);
//   f_ms:  the same average of what a field of radiance 1 from everywhere sends: the share that each order hands on (7);
//   Psi = L_2nd (1 + f_ms + f_ms^2 + ...) = L_2nd / (1 - f_ms) (9, 10), and the source at a point is Psi sigma_s.
// Psi depends on altitude and sun alone: a table, linear in altitude and in the sun's cosine. The kernel that fills it does not have
// it: what it gathers as `multiple` is f_ms.
#ifndef AUREOLE_HILLAIRE_GLSL
#define AUREOLE_HILLAIRE_GLSL

#include "common/geometry.glsl"
#include "common/ray_light.glsl"
#include "common/slab.glsl"
#include "medium/medium.glsl"
#include "models/hillaire/steps.glsl"
#include "transmittance/transmittance.glsl"

real psi_altitude(real position) { return position * shell_thickness(); }
real psi_sun_mu(real position) { return 2 * position - 1; }

#ifdef AUREOLE_MULTI_SCATTER_TABLE
vec3 psi(real altitude, real mu_s) {
    ivec2 size = textureSize(multi_scatter_table, 0);
    return vec3(SAMPLE(multi_scatter_table, vec2(unit_to_texture(real(0.5) + real(0.5) * mu_s, size.x),
                                                 unit_to_texture(min(altitude / shell_thickness(), real(1)), size.y))));
}
#endif

RayLight march_steps(Ray ray, int steps, bool growing) {
    RayLight light = no_light();
    int i = 0;
    do {  // tested at the end: see common/march.glsl
        RayStep s = even_step(ray.end, i, steps);
        if (growing) s = growing_step(ray.end, i, steps);
        real h = altitude_after(ray.altitude, ray.mu, s.t);
        real mu_s = sun_mu_after(ray, s.t, h);
        Medium air = sample_medium(h);
        vec3 slab = air.extinction * s.dt;
        vec3 weight = exp(-light.depth) * mean_transmittance(slab) * s.dt;
        vec3 beam = weight * transmittance_to_sun(h, mu_s);
#ifdef AUREOLE_MULTI_SCATTER_TABLE
        weight *= psi(h, mu_s);
#endif
        for (int c = 0; c < PHASE_COUNT; ++c) {
            light.single[c] += beam * air.scattering[c];
            light.multiple += weight * air.scattering[c];
        }
        light.depth += slab;
        ++i;
    } while (i < steps);
    return light;
}

// Aerial perspective takes as much of each colour, by the mean of the three transmittances, or of each its own.
SPEC_BOOL(28, GREY_TRANSMITTANCE, false)

vec3 transmittance_shown(vec3 depth) {
    vec3 t = exp(-depth);
    return GREY_TRANSMITTANCE ? vec3((t.x + t.y + t.z) / 3) : t;
}

#endif
