// Path tracing in a spherical shell: radiance of all orders as the mean of random paths, without any table.
//
// The light that reaches the camera along a ray obeys (Chandrasekhar 1960, chapter 1)
//   L(v) = integral T(0, t) sum_c sigma_c(t) integral p_c(v . w) L'(t, w) dw dt + T(0, end) albedo / pi integral cos L'(end, w) dw,
// where L' is the suns' light and L itself. A path draws one term of the sum, a place t and a direction w for each of the integrals,
// and goes on there with the weight (what is true) / (density of the draw). From each of its legs the suns' light is taken at one
// place: their directions are known, their transmittance is a quadrature or an estimate without bias (tracking.glsl), the ground's
// shadow is a comparison of cosines (next-event estimation; Pharr, Jakob & Humphreys 2023, section 14.2). A leg always ends in the air
// or on the ground: light that would leave is no part of the sum, so paths are not spent on it, their weight says how much was left.
// All three channels travel together: the density of each draw is that of the mixture over the channels, so no weight can grow large in
// one of them.
//
// The first order is an integral along a line and needs no paths: Gauss nodes (march.glsl), or, if FIRST_ORDER_SAMPLED, as the rest.
//
// Needs `atm`, `view`, `quadrature`, triplet.glsl and both of the user's tables; tracking.glsl has slot 4.
#ifndef AUREOLE_REFERENCE_GLSL
#define AUREOLE_REFERENCE_GLSL

#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES RAY_NODES
SPEC_INT(8, RAY_NODES, 16)               // Gauss nodes of transmittances and of each part of the first order
SPEC_BOOL(10, SINGLE_SCATTERING, true)   // of march.glsl: what it is used for here
SPEC_BOOL(11, MULTIPLE_SCATTERING, false)
SPEC_INT(26, PATHS, 16)                  // paths of a pixel each frame
SPEC_INT(27, MAX_ORDER, 0)               // scattering events and reflections of a path at most; 0: all
#ifdef AUREOLE_FIRST_ORDER_BY_NODES
CONST(bool, FIRST_ORDER_SAMPLED, false)
#else
SPEC_BOOL(28, FIRST_ORDER_SAMPLED, false)
#endif
SPEC_INT(29, FIRST_ORDER_PARTS, 16)      // 1, 2, 4, 8, 16: pieces that the ray is cut into
SPEC_INT(30, ROULETTE_ORDER, 4)          // from here on a path survives with the share that its weight keeps
SPEC_INT(31, SEED, 0)
SPEC_BOOL(36, TRACKED, false)            // transmittances by tracking.glsl in place of quadrature

#include "common/constants.glsl"
#include "common/geometry.glsl"
#include "models/reference/random.glsl"
#include "common/view_ray.glsl"
#include "medium/medium.glsl"
#include "phase/phase.glsl"
#include "phase/phase_sampling.glsl"
#include "transmittance/by_quadrature.glsl"

#include "common/ground.glsl"
#include "models/reference/leg.glsl"
#include "models/reference/tracking.glsl"

CONST(int, LAST_ORDER, 4096)  // of paths without a limit

// A direction at an angle of this cosine from the axis, and the azimuth 2 pi u around it.
vec3 turned(vec3 axis, real cosine, real u) {
    vec3 other = abs(axis.z) < real(0.7) ? vec3(real(0), real(0), real(1)) : vec3(real(1), real(0), real(0));
    vec3 a = normalize(cross(axis, other));
    vec3 b = cross(axis, a);
    real sine = sqrt(max((1 - cosine) * (1 + cosine), real(0)));
    real azimuth = 2 * PI * u;
    return normalize(cosine * axis + sine * (cos(azimuth) * a + sin(azimuth) * b));
}

// Transmittance of the first `t` km of a ray: by nodes, or an estimate without bias.
vec3 transmittance_along(real altitude, real mu, real t, INOUT(Draws) draws) {
    if (TRACKED) return tracked_transmittance(altitude, mu, t, draws);
    return exp(-optical_depth_along(altitude, mu, t));
}
// To a sun in the same way.
vec3 transmittance_of_beam(real altitude, real mu_s, INOUT(Draws) draws) {
    if (!TRACKED) return transmittance_to_sun(altitude, mu_s);
    if (hits_ground(altitude, mu_s)) return vec3(real(0));
    return tracked_transmittance(altitude, mu_s, distance_to_top(altitude, mu_s), draws);
}

// Where nodes overlook most of the air, a truth by quadrature is any number of times the density of what was drawn, and so it goes from
// event to event: what a path weighs, and what one of its draws brings of a unit of sunlight, ends here. Of air that the nodes know
// nothing comes near.
CONST(real, MOST_OF_A_DRAW, real(1e9))
CONST(real, MOST_WEIGHT, real(1e9))

// Light of the suns from a place on the leg, in the air or on the ground at its end, on its way along the leg, of this weight.
vec3 light_from(Walk walk, real t, bool on_ground, vec3 weight, int only, INOUT(Draws) draws) {
    Walk there = walk_on(walk, t, on_ground);
    Medium air = sample_medium(there.altitude);
    vec3 through = transmittance_along(walk.altitude, walk.mu, t, draws);
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        vec3 towards = vec3(view.sun_direction[sun]);
        real mu_s = dot(there.up, towards);
        vec3 sent = on_ground ? max(mu_s, real(0)) / PI * vec3(atm.ground_albedo) : scattered_to(air, walk.direction, towards);
        vec3 lit = sent * transmittance_of_beam(there.altitude, mu_s, draws);
        radiance += lit_by(sun, only, min(weight * (through * lit), vec3(MOST_OF_A_DRAW)));
    }
    return radiance;
}
// The same roughly, to choose between the two.
real rough_ground_light(Walk walk, Leg leg, vec3 weight, int only) {
    vec3 up = walk_on(walk, leg.end, true).up;
    vec3 irradiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        real mu_s = dot(up, vec3(view.sun_direction[sun]));
        irradiance += max(mu_s, real(0)) * exp(-rough_sun_depth(real(0), mu_s)) * sunlight(sun, only);
    }
    return dot(weight, ground_radiance(leg.depth, irradiance));
}
// One draw of the light along a leg.
vec3 light_on_leg(Walk walk, Leg leg, vec3 weight, vec4 random, int only, INOUT(Draws) draws) {
    LegLight light = light_of(leg, weight);
    real ground = leg.ground ? rough_ground_light(walk, leg, weight, only) : real(0);
    real share = ground > 0 ? (TERM_COUNT == 0 ? real(1) : clamp(ground / (ground + light.whole), real(0.05), real(0.95))) : real(0);
    bool on_ground = random.x < share;
    Place place = draw_lit_place(leg, light, weight, random.y, random.z);
    real density = on_ground ? share : place.density * (1 - share);
    if (!(density > 0)) return vec3(real(0));
    return light_from(walk, on_ground ? leg.end : place.t, on_ground, weight / density, only, draws);
}

// Light scattered or reflected once, by quadrature. A kernel may take other values of phase functions by defining
// AUREOLE_FIRST_PHASE(c, nu).
#ifndef AUREOLE_FIRST_PHASE
#define AUREOLE_FIRST_PHASE(c, nu) phase_value(c, nu)
#endif
vec3 first_order(Walk walk, Leg leg, int only) {
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        vec3 towards = vec3(view.sun_direction[sun]);
        Ray whole;
        whole.altitude = walk.altitude;
        whole.mu = walk.mu;
        whole.mu_s = dot(walk.up, towards);
        whole.nu = dot(walk.direction, towards);
        whole.end = leg.end;
        whole.ground = leg.ground;
        vec3 depth = vec3(real(0));
        vec3 sum = vec3(real(0));
        int part = 0;
        do {
            real from = leg.at[part * (LEG_CELLS / FIRST_ORDER_PARTS)];
            Ray ray = whole;
            ray.altitude = altitude_after(whole.altitude, whole.mu, from);
            ray.mu = view_mu_after(whole, from, ray.altitude);
            ray.mu_s = sun_mu_after(whole, from, ray.altitude);
            ray.end = leg.at[(part + 1) * (LEG_CELLS / FIRST_ORDER_PARTS)] - from;
            if (ray.end > 0) {
                RayLight light = march(ray);
                for (int c = 0; c < PHASE_COUNT; ++c) sum += exp(-depth) * light.single[c] * AUREOLE_FIRST_PHASE(c, ray.nu);
                depth += light.depth;
            }
            ++part;
        } while (part < FIRST_ORDER_PARTS);
        if (leg.ground) sum += ground_radiance(depth, ground_beam_irradiance(sun_mu_after(whole, leg.end, real(0))));
        radiance += lit_by(sun, only, sum);
    }
    return radiance;
}

// Where a path goes from a place: about an axis, as the phase functions there scatter, or, one time in four, about a sun. Light that
// arrives nearly along a sun's beam is scattered forwards once more, so strongly that paths which only ever found it by chance would
// scatter far about their mean.
CONST(real, SUN_SHARE, real(0.25))

struct Lobes {
    real share[MAX_PHASES];  // of the phase functions, by what the air there scatters of the weight
    real sum;
};
Lobes lobes_of(Medium air, vec3 weight) {
    Lobes lobes;
    lobes.sum = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        lobes.share[c] = dot(weight, air.scattering[c]);
        lobes.sum += lobes.share[c];
    }
    return lobes;
}
// A cosine from them, and their density, 1/sr. There must be something to choose from.
real draw_cosine(Lobes lobes, real pick, real u, real v) {
    int chosen = 0;
    real passed = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        if (lobes.share[c] > 0 && pick * lobes.sum >= passed) chosen = c;
        passed += lobes.share[c];
    }
    return sample_phase(chosen, u, v);
}
real cosine_density(Lobes lobes, real nu) {
    real density = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) density += lobes.share[c] * sampled_phase_density(c, nu);
    return density / lobes.sum;
}
// Chances of the suns.
real sun_chance(int sun, int only) { return dot(sunlight(sun, only), vec3(real(1))); }
struct SunChoice {
    vec3 towards;
    real all;  // sum of the chances; 0: no sun shines
};
SunChoice choose_sun(real pick, int only) {
    SunChoice choice;
    choice.all = real(0);
    for (int sun = 0; sun < SUN_COUNT; ++sun) choice.all += sun_chance(sun, only);
    choice.towards = vec3(view.sun_direction[0]);
    real passed = real(0);
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        real chance = sun_chance(sun, only);
        if (chance > 0 && pick * choice.all >= passed) choice.towards = vec3(view.sun_direction[sun]);
        passed += chance;
    }
    return choice;
}
real sun_lobes_density(Lobes lobes, vec3 direction, real all, int only) {
    real density = real(0);
    for (int sun = 0; sun < SUN_COUNT; ++sun)
        density += sun_chance(sun, only) / all * cosine_density(lobes, dot(direction, vec3(view.sun_direction[sun])));
    return density;
}

// The next direction; the weight takes what phase functions and scattering coefficients, or the ground's cosine and albedo, say.
vec3 turn(Walk walk, bool on_ground, vec4 random, real sun_pick, int only, INOUT(vec3) weight) {
    Medium air = sample_medium(walk.altitude);
    Lobes lobes = lobes_of(air, weight);
    SunChoice sun = choose_sun(sun_pick, only);
    bool scatters = lobes.sum > 0;
    real sun_share = scatters && sun.all > 0 ? SUN_SHARE : real(0);
    bool to_sun = random.x < sun_share;
    real pick = to_sun ? random.x / max(sun_share, real(1e-20)) : (random.x - sun_share) / (1 - sun_share);
    // By the cosine from the ground.
    real cosine = on_ground && !to_sun ? sqrt(random.y) : (scatters ? draw_cosine(lobes, pick, random.y, random.z) : real(1));
    vec3 direction = turned(to_sun ? sun.towards : (on_ground ? walk.up : walk.direction), cosine, random.w);

    real nu = to_sun ? dot(on_ground ? walk.up : walk.direction, direction) : cosine;
    vec3 truth = max(nu, real(0)) / PI * vec3(atm.ground_albedo);
    real density = max(nu, real(0)) / PI;
    if (!on_ground) {
        truth = vec3(real(0));
        for (int c = 0; c < PHASE_COUNT; ++c) truth += air.scattering[c] * phase_value(c, nu);
        density = scatters ? cosine_density(lobes, nu) : real(0);
    }
    if (sun_share > 0) density = mix(density, sun_lobes_density(lobes, direction, sun.all, only), sun_share);
    weight = density > 0 ? weight * truth / density : vec3(real(0));
    return direction;
}

real largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// One path: what it finds of all orders, or from the second on. (x, y, path) choose its random numbers.
vec3 path_radiance(Walk walk, Leg leg, int only, uint x, uint y, uint path) {
    vec3 radiance = vec3(real(0));
    vec3 weight = vec3(real(1));
    uint draw = uint(SEED) * 2654435769u;
    Draws draws = tracking_draws(x, y, path, draw);
    int limit = MAX_ORDER > 0 ? MAX_ORDER : LAST_ORDER;
    real kept = real(0);  // weight that roulette keeps up
    for (int order = 1; order <= limit; ++order) {
        vec4 where = random_numbers(x, y, path, draw);
        vec4 whither = random_numbers(x, y, path, draw + 1u);
        vec4 light = random_numbers(x, y, path, draw + 2u);
        draw += 3u;
        if (order > 1 || FIRST_ORDER_SAMPLED) radiance += light_on_leg(walk, leg, weight, light, only, draws);
        if (order <= ROULETTE_ORDER) kept = largest(weight);

        // The ground, or the air before it, by what the stand-in says of their shares.
        real reflected = dot(weight * exp(-leg.depth), vec3(atm.ground_albedo));
        real caught = dot(weight, caught_share(leg));
        // What is drawn against all odds is drawn ever more rarely: in air where light goes a long way the others' weight, which makes up
        // for it, would grow without end.
        real least = real(0.02) / real(order);
        bool reflects = leg.ground && largest(vec3(atm.ground_albedo)) > 0;
        real ground_share = !reflects ? real(0)
                            : (TERM_COUNT == 0 ? real(1) : clamp(reflected / max(reflected + caught, real(1e-30)), least, real(0.95)));
        bool on_ground = where.x < ground_share;
        Place place;
        place.t = leg.end;
        place.density = real(1);
        if (!on_ground) place = draw_place(leg, weight, EVEN_SHARE / real(order), where.y, where.z);
        weight *= transmittance_along(walk.altitude, walk.mu, place.t, draws) / (on_ground ? ground_share : 1 - ground_share);
        weight = place.density > 0 ? min(weight / place.density, vec3(MOST_WEIGHT)) : vec3(real(0));
        walk = walk_on(walk, place.t, on_ground);

        walk.direction = turn(walk, on_ground, whither, light.w, only, weight);
        walk.mu = dot(walk.up, walk.direction);

        // Roulette: from some order on what is left of the weight is the chance to go on, and survivors make up for the others.
        if (order >= ROULETTE_ORDER) {
            real chance = clamp(largest(weight) / max(kept, real(1e-30)), real(0.05), real(1));
            weight = where.w < chance ? weight / chance : vec3(real(0));
        }
        if (!(largest(weight) > 0) || order == limit) break;
        leg = leg_to_end(walk, true, only);
    }
    return radiance;
}

// Mean of many paths and how far they scatter around it (Welford 1962), which loses nothing to cancellation.
struct Estimate {
    vec3 mean;
    vec3 spread;  // sum of the squared distances from the mean
    real count;
};
Estimate no_estimate() {
    Estimate estimate;
    estimate.mean = vec3(real(0));
    estimate.spread = vec3(real(0));
    estimate.count = real(0);
    return estimate;
}
void add_sample(INOUT(Estimate) estimate, vec3 value) {
    estimate.count += 1;
    vec3 apart = value - estimate.mean;
    estimate.mean += apart / estimate.count;
    estimate.spread += apart * (value - estimate.mean);
}
vec3 standard_error(Estimate estimate) {
    return sqrt(estimate.spread / max(estimate.count * (estimate.count - 1), real(1)));
}

bool needs_paths() { return FIRST_ORDER_SAMPLED || MAX_ORDER != 1; }
vec3 exact_part(Walk walk, Leg leg, int only) {
    return FIRST_ORDER_SAMPLED ? vec3(real(0)) : first_order(walk, leg, only);
}
// Adds the paths [first, first + count).
void add_paths(INOUT(Estimate) estimate, Walk walk, Leg leg, int only, uint x, uint y, int first, int count) {
    if (!needs_paths()) return;
    for (int i = 0; i < count; ++i) add_sample(estimate, path_radiance(walk, leg, only, x, y, uint(first + i)));
}

#endif
