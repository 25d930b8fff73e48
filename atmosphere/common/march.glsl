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
    vec2 air = extinction_and_decay(h);
    // Seen from its thin end, a piece does not fade with distance from the dense one.
    return ray_map(t1 - t0, h, abs(view_mu_after(ray, t, h)), air.y, dense_end ? real(0) : air.x);
}

// A channel is followed through so many optical depths in one piece: nodes that reach farther see too little of the first few.
CONST(real, OPAQUE_DEPTH, real(8))
// Behind so many a channel shows 2.5e-3 of its light, of which nodes wherever they are miss a part.
CONST(real, HIDDEN_DEPTH, real(6))
CONST(int, MOST_CUTS, 3)

// Above 1 where a channel becomes opaque that is still seen, `before` being the depths in front of the piece; in proportion to its depth.
real opacity(vec3 depth, vec3 before) {
    vec3 seen = mix(depth, vec3(real(0)), lessThan(vec3(HIDDEN_DEPTH), before));
    return max(seen.x, max(seen.y, seen.z)) / OPAQUE_DEPTH;
}
bool hidden(vec3 depth) { return min(depth.x, min(depth.y, depth.z)) >= HIDDEN_DEPTH; }

// Where a piece whose far end is dense becomes opaque in some channel (t1 if it does not), by the air at its nodes and at its ends: between two of
// them it is taken to be no denser than at the thinner. Found along straight lines, so that it moves steadily with the ray.
real opaque_distance(Ray ray, real t0, real t1, RayMap map, vec3 before) {
    real t = t0;
    vec3 extinction = vec3(real(0));
    vec3 depth = vec3(real(0));
    real so_far = real(0);
    for (int k = 0; k < RAY_NODES + 2; ++k) {  // the beginning, the nodes from there on, the end
        real next_t = k == 0 ? t0 : t1;
        if (k > 0 && k <= RAY_NODES) next_t -= map_distance(map, quadrature.node[RAY_NODES - k].x);
        COUNT(1);
        vec3 next_extinction = medium_extinction(altitude_after(ray.altitude, ray.mu, next_t));
        depth += min(extinction, next_extinction) * (next_t - t);
        real reached = opacity(depth, before);
        if (reached > 1) return t + (next_t - t) * (1 - so_far) / (reached - so_far);
        t = next_t;
        extinction = next_extinction;
        so_far = reached;
    }
    return t1;
}

// One smooth piece [t0, t1] of the ray, after what `light` has gathered already. Where its nodes lie towards its far end, and may all
// be behind what a channel shows, it is cut there: t1 comes back as its new end, for the other channels to go on from, or, where
// nothing behind it is seen in any, as it was, and `opaque` is true.
void march_piece(Ray ray, real t0, INOUT(real) t1, bool dense_end, bool lit, INOUT(RayLight) light, INOUT(bool) opaque) {
    LOCAL_ARRAY(real, density, RAY_NODES * (TERM_COUNT + 1), MAX_NODES * (MAX_TERMS + 1))  // times dt/du
    real uncut = t1;
    vec3 uncut_depth = vec3(real(0));
    vec3 whole = vec3(real(0));
    RayMap map;
    for (int cut = 0; cut <= MOST_CUTS; ++cut) {
        map = piece_map(ray, t0, t1, dense_end);
        // The more of the piece is hidden, the less of a scale height is left: what falls within it is the light, from its thin end.
        if (cut > 0) map.linear = mix(real(1), map.linear, (t1 - t0) / (uncut - t0));
        whole = vec3(real(0));
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
        if (cut == 0) uncut_depth = whole;
        if (!dense_end || cut == MOST_CUTS || opacity(whole, light.depth) <= 1) break;
        real end = opaque_distance(ray, t0, t1, map, light.depth);
        if (end >= t1) break;
        t1 = end;
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
    // The air behind an opaque piece is taken to shine as what is seen of it.
    opaque = t1 < uncut && hidden(light.depth + whole);
    vec3 passed = opaque ? uncut_depth : whole;
    vec3 exact = exp(-light.depth) * passed * mean_transmittance(passed);
    vec3 none = vec3(real(1e-20));
    vec3 share = mix(exact / max(caught, none), vec3(real(1)), lessThan(caught, none));
    if (SINGLE_SCATTERING)
        for (int c = 0; c < PHASE_COUNT; ++c) light.single[c] += share * single[c];
    if (MULTIPLE_SCATTERING) light.multiple += share * multiple;
    light.depth += passed;
    if (opaque) t1 = uncut;
}

// The whole ray, cut at its lowest point, at the edges of the shadow, and where air far ahead hides what is behind it.
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
    bool opaque = false;
    for (int piece = 0; piece < 7; ++piece) {  // of the four between the cuts, a channel each may end one early
        real end = ray.end;
        if (cut3 > begin + shortest) end = cut3;
        if (cut2 > begin + shortest) end = cut2;
        if (cut1 > begin + shortest) end = cut1;
        real middle = real(0.5) * (begin + end);
        bool lit = middle < shadow.x || middle > shadow.y;
        if ((MULTIPLE_SCATTERING || lit) && !opaque) march_piece(ray, begin, end, middle < lowest, lit, light, opaque);
        else light.depth += dark_depth(ray, begin, end, middle >= lowest);
        begin = end;
        if (begin >= ray.end - shortest) break;
    }
    return light;
}

#endif
