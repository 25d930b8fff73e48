// Light gathered along a ray: the integral of what the air scatters towards the camera, times the transmittance back to it.
//
// Along a piece of the ray on which the integrand is smooth, N Gauss-Legendre nodes, placed by ray_map.glsl, converge
// exponentially: eight beat sixty-four uniform steps a hundred times (docs/quadrature.md). So the ray is cut where it is not smooth:
// where it enters or leaves the planet's shadow (single scattering only lives on the sunlit pieces), and at its lowest point;
// each piece has its dense end where the air is dense. The transmittance from the camera comes from the same nodes: density at
// the nodes, multiplied by the matrix of running integrals of the interpolating polynomial, is the optical depth at the nodes.
//
// The including kernel declares atm, quadrature and transmittance_table, or instead of the last includes
// transmittance/by_quadrature.glsl or what does the same; and says
//   SPEC_INT(…, RAY_NODES, …), SPEC_BOOL(…, SINGLE_SCATTERING, …), SPEC_BOOL(…, MULTIPLE_SCATTERING, …).
// If the last may be true, it has a multi_scatter_table, or a scattered_diffuse(...) of its own and AUREOLE_OWN_SCATTERED_DIFFUSE defined.
#ifndef AUREOLE_MARCH_GLSL
#define AUREOLE_MARCH_GLSL

#include "common/dark_depth.glsl"
#include "common/geometry.glsl"
#include "common/ray_light.glsl"
#include "common/ray_map.glsl"
#include "common/slab.glsl"
#include "medium/medium.glsl"
#ifndef AUREOLE_OWN_SCATTERED_DIFFUSE
#include "multi_scatter/multi_scatter.glsl"
#endif
#include "transmittance/transmittance.glsl"

// Places the nodes of a piece by the air at its dense end.
RayMap piece_map(Ray ray, real t0, real t1, bool dense_end) {
    real t = dense_end ? t1 : t0;
    real h = altitude_after(ray.altitude, ray.mu, t);
    COUNT(1);
    real extinction = real(0);
    real decay = real(0);  // extinction-weighted 1 / scale height
    for (int i = 0; i < TERM_COUNT; ++i) {
        vec3 e = vec3(atm.term_extinction[i]) * term_density(i, h);
        real mean = (e.x + e.y + e.z) / 3;
        extinction += mean;
        if (term_kind(i) == PROFILE_EXPONENTIAL) decay += mean * atm.term_profile[i].x;
    }
    decay /= max(extinction, real(1e-20));
    // Seen from its thin end, a piece does not fade with distance from the dense one.
    return ray_map(t1 - t0, h, abs(view_mu_after(ray, t, h)), decay, dense_end ? real(0) : extinction);
}

// One smooth piece [t0, t1] of the ray, after what `light` has gathered already.
void march_piece(Ray ray, real t0, real t1, bool dense_end, bool lit, INOUT(RayLight) light) {
    RayMap map = piece_map(ray, t0, t1, dense_end);
    LOCAL_ARRAY(real, density, RAY_NODES * (TERM_COUNT + 1), MAX_NODES * (MAX_TERMS + 1))  // times dt/du

    vec3 whole = vec3(real(0));
    for (int j = 0; j < RAY_NODES; ++j) {
        COUNT(1);
        real u = quadrature.node[j].x;
        real s = map_distance(map, u);
        real rate = map_rate(map, u);
        real h = altitude_after(ray.altitude, ray.mu, dense_end ? t1 - s : t0 + s);
        for (int i = 0; i < TERM_COUNT; ++i) {
            real d = term_density(i, h) * rate;
            density[j * (TERM_COUNT + 1) + i] = d;
            whole += (d * quadrature.node[j].y) * vec3(atm.term_extinction[i]);
        }
    }

    vec3 single[MAX_PHASES];
    for (int c = 0; c < PHASE_COUNT; ++c) single[c] = vec3(real(0));
    vec3 multiple = vec3(real(0));
    vec3 caught = vec3(real(0));  // integral of extinction times transmittance, as the nodes have it
    int k = 0;
    do {  // tested at the end, as in march() below
        real u = quadrature.node[k].x;
        real s = map_distance(map, u);
        real t = dense_end ? t1 - s : t0 + s;
        real h = altitude_after(ray.altitude, ray.mu, t);
        real mu_s = sun_mu_after(ray, t, h);

        vec3 running = vec3(real(0));
        vec3 scattering[MAX_PHASES];
        vec3 extinction = vec3(real(0));
        for (int c = 0; c < PHASE_COUNT; ++c) scattering[c] = vec3(real(0));
        for (int i = 0; i < TERM_COUNT; ++i) {
            real d = real(0);
            for (int j = 0; j < RAY_NODES; ++j)
                d += quadrature.running[4 * k + j / 4][j % 4] * density[j * (TERM_COUNT + 1) + i];
            running += d * vec3(atm.term_extinction[i]);
            real here = density[k * (TERM_COUNT + 1) + i] * quadrature.node[k].y;
            scattering[term_phase(i)] += here * vec3(atm.term_scattering[i]);
            extinction += here * vec3(atm.term_extinction[i]);
        }
        // The interpolating polynomial may swing below 0 or above the whole where the density is steep.
        running = clamp(running, vec3(real(0)), whole);
        vec3 transmittance = exp(-(light.depth + (dense_end ? whole - running : running)));
        caught += transmittance * extinction;

        if (SINGLE_SCATTERING && lit) {
            vec3 beam = transmittance * transmittance_to_top(h, mu_s);
            for (int c = 0; c < PHASE_COUNT; ++c) single[c] += beam * scattering[c];
        }
#if defined(AUREOLE_MULTI_SCATTER_TABLE) || defined(AUREOLE_OWN_SCATTERED_DIFFUSE)
        if (MULTIPLE_SCATTERING)
            multiple += transmittance * scattered_diffuse(h, view_mu_after(ray, t, h), mu_s, ray.nu, scattering);
#endif
        ++k;
    } while (k < RAY_NODES);
    // What a piece catches is known: 1 - exp(-whole). In thick air a few nodes miss it, by either sign, and where the fixed point of
    // multiple scattering caught more than there is, it would grow without end.
    vec3 exact = exp(-light.depth) * whole * mean_transmittance(whole);
    vec3 none = vec3(real(1e-20));
    vec3 share = mix(exact / max(caught, none), vec3(real(1)), lessThan(caught, none));
    if (SINGLE_SCATTERING)
        for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += share * single[c];
    if (MULTIPLE_SCATTERING) light.multiple += share * multiple;
    light.depth += whole;
}

// The whole ray, cut at its lowest point and at the edges of the shadow.
RayLight march(Ray ray) {
    RayLight light = no_light();
    real lowest = ray.ground ? ray.end : clamp(-(bottom_radius() + ray.altitude) * ray.mu, real(0), ray.end);
    vec2 shadow = SINGLE_SCATTERING ? shadow_interval(ray) : vec2(real(0));
    // Cuts in order: of the three, the lowest point may lie before, inside or after the shadow.
    real cut1 = min(lowest, shadow.x);
    real cut2 = max(min(lowest, shadow.y), shadow.x);
    real cut3 = max(lowest, shadow.y);
    real shortest = real(1e-7) * ray.end;
    real begin = real(0);
    // Most rays are one piece, and a vectorizing driver leaves a loop only at its end: a test at the start alone would cost an
    // empty round. Rays leave this loop at different rounds, so it keeps a second exit: where such a loop has one exit only, at
    // its end, llvmpipe 22.3 lets the rays that left early take over sums of the rays that stayed.
    for (int piece = 0; piece < 4; ++piece) {
        real end = ray.end;
        if (cut3 > begin + shortest) end = cut3;
        if (cut2 > begin + shortest) end = cut2;
        if (cut1 > begin + shortest) end = cut1;
        real middle = real(0.5) * (begin + end);
        bool lit = middle < shadow.x || middle > shadow.y;
        if (MULTIPLE_SCATTERING || lit) march_piece(ray, begin, end, middle < lowest, lit, light);
        else light.depth += dark_depth(ray, begin, end, middle >= lowest);
        begin = end;
        if (begin >= ray.end - shortest) break;
    }
    return light;
}

#endif
