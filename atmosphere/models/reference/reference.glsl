// Path tracing in a spherical shell: radiance of all orders as the mean of random paths, without any table.
//
// The light that reaches the camera along a ray obeys (Chandrasekhar 1960, chapter 1)
//   L(v) = integral T(0, t) sum_c sigma_c(t) integral p_c(v . w) L'(t, w) dw dt + T(0, end) albedo / pi integral cos L'(end, w) dw,
// where L' is the suns' light and L itself. A path draws one term of the sum, a place t and a direction w for each of the integrals,
// and goes on there with the weight (what is true) / (density of the draw). At each of its places the suns' light is added exactly:
// their directions are known, their transmittance is a quadrature, the ground's shadow is a comparison of cosines (next-event
// estimation; Pharr, Jakob & Humphreys 2023, section 14.2). A leg always ends in the air or on the ground: light that would leave is
// no part of the sum, so paths are not spent on it, their weight says how much was left. All three channels travel together: the
// density of each draw is that of the mixture over the channels, so no weight can grow large in one of them.
//
// The first order is an integral along a line and needs no paths: Gauss nodes (march.glsl), or, if FIRST_ORDER_SAMPLED, as the rest.
//
// Needs `atm`, `view`, `quadrature` and both of the user's tables.
#ifndef AUREOLE_REFERENCE_GLSL
#define AUREOLE_REFERENCE_GLSL

#define AUREOLE_TRANSMITTANCE_COLUMN
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
SPEC_INT(29, FIRST_ORDER_PARTS, 4)       // 1, 2, 4, 8, 16: pieces that the ray is cut into
SPEC_INT(30, ROULETTE_ORDER, 4)          // from here on a path survives with the share that its weight keeps
SPEC_INT(31, SEED, 0)

#include "common/constants.glsl"
#include "common/geometry.glsl"
#include "common/random.glsl"
#include "common/view_ray.glsl"
#include "medium/medium.glsl"
#include "phase/phase.glsl"
#include "phase/phase_sampling.glsl"
#include "transmittance/column.glsl"
#include "transmittance/transmittance.glsl"

// march.glsl asks for the diffuse field, which is what paths are for.
vec3 scattered_diffuse(real, real, real, real, vec3[MAX_PHASES]) { return vec3(real(0)); }

#include "common/ground.glsl"
#include "models/reference/leg.glsl"

CONST(int, ALL_SUNS, -1)
CONST(int, LAST_ORDER, 4096)  // of paths without a limit

// Light of a sun at the top of the air: all suns together, or of one a unit.
vec3 sunlight(int sun, int only) {
    if (only == ALL_SUNS) return vec3(view.sun_irradiance[sun]);
    return vec3(only == sun ? real(1) : real(0));
}

// A point in the air and a direction there.
struct Walk {
    real altitude;
    vec3 up;         // unit, from the planet's centre, world axes
    vec3 direction;  // unit, away from the camera
    real mu;         // cosine between the two
};

// The walk of a camera's ray: where it enters the air, or misses it.
struct CameraWalk {
    Walk walk;
    bool met;
};
CameraWalk camera_walk(vec3 direction, ViewDirection v) {
    CameraWalk result;
    real entry = distance_to_air(v);
    result.met = entry >= 0;
    Ray ray = air_ray(v, max(entry, real(0)), 0, real(0));
    result.walk.altitude = ray.altitude;
    result.walk.mu = ray.mu;
    result.walk.direction = direction;
    vec3 there = (bottom_radius() + view.space.x) * vec3(view.up) + max(entry, real(0)) * direction;
    result.walk.up = view.camera.w > real(0.5) ? normalize(there) : vec3(view.up);
    return result;
}

// After a distance t, with the zenith cosine that belongs to it.
Walk walk_on(Walk walk, real t, bool ground) {
    Walk next;
    next.altitude = ground ? real(0) : min(altitude_after(walk.altitude, walk.mu, t), shell_thickness());
    next.up = normalize((bottom_radius() + walk.altitude) * walk.up + t * walk.direction);
    next.direction = walk.direction;
    next.mu = dot(next.up, next.direction);
    return next;
}

// A direction at an angle of this cosine from the axis, and the azimuth 2 pi u around it.
vec3 turned(vec3 axis, real cosine, real u) {
    vec3 other = abs(axis.z) < real(0.7) ? vec3(real(0), real(0), real(1)) : vec3(real(1), real(0), real(0));
    vec3 a = normalize(cross(axis, other));
    vec3 b = cross(axis, a);
    real sine = sqrt(max((1 - cosine) * (1 + cosine), real(0)));
    real azimuth = 2 * PI * u;
    return normalize(cosine * axis + sine * (cos(azimuth) * a + sin(azimuth) * b));
}

// Sunlight that air sends on along the walk, per unit of the weight.
vec3 lit_air(Walk walk, Medium air, int only) {
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        vec3 towards = vec3(view.sun_direction[sun]);
        vec3 scattered = vec3(real(0));
        for (int c = 0; c < PHASE_COUNT; ++c) scattered += air.scattering[c] * phase_value(c, dot(walk.direction, towards));
        radiance += scattered * transmittance_to_sun(walk.altitude, dot(walk.up, towards)) * sunlight(sun, only);
    }
    return radiance;
}
vec3 lit_ground(Walk walk, int only) {
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun)
        radiance += ground_radiance(vec3(real(0)), ground_beam_irradiance(dot(walk.up, vec3(view.sun_direction[sun])))) *
                    sunlight(sun, only);
    return radiance;
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
        radiance += sum * sunlight(sun, only);
    }
    return radiance;
}

// Where the path goes from a point in the air; the weight takes what phase functions and scattering coefficients say.
vec3 scatter(Medium air, vec3 axis, vec4 random, INOUT(vec3) weight) {
    real share[MAX_PHASES];
    real sum = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        share[c] = dot(weight, air.scattering[c]);
        sum += share[c];
    }
    real pick = random.x * sum;
    int chosen = 0;
    real passed = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        if (share[c] > 0 && pick >= passed) chosen = c;
        passed += share[c];
    }
    real nu = sample_phase(chosen, random.y, random.z);
    vec3 truth = vec3(real(0));
    real drawn = real(0);
    for (int c = 0; c < PHASE_COUNT; ++c) {
        truth += air.scattering[c] * phase_value(c, nu);
        drawn += share[c] * sampled_phase_density(c, nu);
    }
    weight = drawn > 0 ? weight * truth * (sum / drawn) : vec3(real(0));
    return turned(axis, nu, random.w);
}

real largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// One path: what it finds of all orders, or from the second on. (x, y, path) choose its random numbers.
vec3 path_radiance(Walk walk, Leg leg, int only, uint x, uint y, uint path) {
    vec3 radiance = vec3(real(0));
    vec3 weight = vec3(real(1));
    uint draw = uint(SEED) * 2654435769u;
    int limit = MAX_ORDER > 0 ? MAX_ORDER : LAST_ORDER;
    for (int order = 1; order <= limit; ++order) {
        vec4 where = random_numbers(x, y, path, draw);
        vec4 whither = random_numbers(x, y, path, draw + 1u);
        draw += 2u;
        real before = largest(weight);

        // The ground, or the air before it, by what the stand-in says of their shares.
        real reflected = dot(weight * exp(-leg.depth), vec3(atm.ground_albedo));
        real caught = dot(weight, caught_share(leg));
        bool reflects = leg.ground && largest(vec3(atm.ground_albedo)) > 0;
        real ground_share = !reflects ? real(0)
                            : (TERM_COUNT == 0 ? real(1) : clamp(reflected / max(reflected + caught, real(1e-30)), real(0.02), real(0.95)));
        bool on_ground = where.x < ground_share;
        Place place;
        place.t = leg.end;
        place.density = real(1);
        if (!on_ground) place = draw_place(leg, weight, where.y, where.z);
        weight *= exp(-optical_depth_along(walk.altitude, walk.mu, place.t)) / (on_ground ? ground_share : 1 - ground_share);
        weight = place.density > 0 ? weight / place.density : vec3(real(0));
        walk = walk_on(walk, place.t, on_ground);

        bool counts = order > 1 || FIRST_ORDER_SAMPLED;
        if (on_ground) {
            if (counts) radiance += weight * lit_ground(walk, only);
            // By the cosine: its density cancels that of the reflection but for the albedo.
            walk.mu = sqrt(whither.y);
            walk.direction = turned(walk.up, walk.mu, whither.w);
            weight *= vec3(atm.ground_albedo);
        } else {
            Medium air = sample_medium(walk.altitude);
            if (counts) radiance += weight * lit_air(walk, air, only);
            walk.direction = scatter(air, walk.direction, whither, weight);
            walk.mu = dot(walk.up, walk.direction);
        }

        // Roulette: from some order on what is left of the weight is the chance to go on, and survivors make up for the others.
        if (order >= ROULETTE_ORDER) {
            real chance = clamp(largest(weight) / max(before, real(1e-30)), real(0.05), real(1));
            weight = where.w < chance ? weight / chance : vec3(real(0));
        }
        if (!(largest(weight) > 0) || order == limit) break;
        leg = leg_to_end(walk.altitude, walk.mu);
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
