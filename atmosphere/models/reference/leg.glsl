// A leg of a path: a straight line through the air to the ground, to the top or to a given end, on which a place to scatter is drawn.
//
// The place is drawn from a stand-in for the air: extinction at the ends of LEG_CELLS cells, linear between them, whose optical depth
// is a parabola in each cell and therefore easily inverted. A path weighs what is true divided by the density of what was drawn, so
// the stand-in makes noise at worst, never an error; the true transmittance comes from quadrature (transmittance/column.glsl). So that
// air which the stand-in overlooks between two of its nodes is met too, one place in sixteen is drawn evenly over the cells.
//
// A leg has two places: one where the path goes on, and one from which the suns' light is taken. The latter is drawn from the light
// itself, as the ends of the cells see it: what the air there sends on, behind the air on the leg, under a closed form for the air
// before the sun. At dusk only a distant part of a leg is lit, and paths that looked for light where they meet the air would rarely
// find it: their mean would be right, but a few of them would carry it all.
#ifndef AUREOLE_LEG_GLSL
#define AUREOLE_LEG_GLSL

#include "common/march.glsl"
#include "models/reference/walk.glsl"

CONST(int, LEG_CELLS, 16)
CONST(real, EVEN_SHARE, real(0.0625))

struct Leg {
    real end;                      // length, km
    bool ground;                   // ends on the ground
    real at[LEG_CELLS + 1];        // distances of the cells' ends
    vec3 extinction[LEG_CELLS + 1];
    vec3 lit[LEG_CELLS + 1];       // what the air there sends on of the suns' light along the leg, by the stand-in
    vec3 depth;                    // optical depth of the whole, by the stand-in
};

// Optical depth to a sun in the air of the exponential terms, roughly: their density times the distance over which it falls by e, or
// by a little less where the ray is flat (sqrt(pi / 2) of sqrt(r H) instead of sqrt(2)); for a sun below the horizontal twice what
// is behind the lowest point less what is behind the point itself.
real rising_column(real altitude, real mu, real height) {
    real r = bottom_radius() + altitude;
    real c = height * (2 * r + height);
    real scale = c / (r * mu + sqrt(r * mu * (r * mu) + c));
    real column = scale * (real(0.886) + real(0.114) * min(scale * mu / height, real(1)));
    return exp(-altitude / height) * min(column, distance_to_top(altitude, mu));  // air that is nearly even ends at the top
}
vec3 rough_sun_depth(real altitude, real mu) {
    real sine = sqrt(max((1 - mu) * (1 + mu), real(0)));
    real lowest = max(altitude - (bottom_radius() + altitude) * mu * mu / (1 + sine), real(0));
    vec3 depth = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) {
        if (term_kind(i) != PROFILE_EXPONENTIAL) continue;
        real height = 1 / atm.term_profile[i].x;
        real column = rising_column(altitude, abs(mu), height);
        if (mu < 0) column = max(2 * rising_column(lowest, real(0), height) - column, real(0));
        depth += column * vec3(atm.term_extinction[i]);
    }
    return depth;
}

// The suns' light that air at the walk's place sends on along it, by the stand-in.
vec3 rough_light(Walk walk, real altitude, vec3 up, int only) {
    Medium air = sample_medium(altitude);
    vec3 radiance = vec3(real(0));
    for (int sun = 0; sun < SUN_COUNT; ++sun) {
        vec3 towards = vec3(view.sun_direction[sun]);
        real mu_s = dot(up, towards);
        if (!hits_ground(altitude, mu_s))
            radiance += scattered_to(air, walk.direction, towards) * exp(-rough_sun_depth(altitude, mu_s)) * sunlight(sun, only);
    }
    return radiance;
}

// Cells are short where the air is dense; one ends at the lowest point. Without `lights` no light is taken from the leg.
Leg make_leg(Walk walk, real end, bool ground, bool lights, int only) {
    real altitude = walk.altitude;
    real mu = walk.mu;
    Leg leg;
    leg.end = end;
    leg.ground = ground;
    Ray ray;
    ray.altitude = altitude;
    ray.mu = mu;
    ray.mu_s = real(0);
    ray.nu = real(0);
    ray.end = end;
    ray.ground = ground;
    real lowest = ground ? end : clamp(-(bottom_radius() + altitude) * mu, real(0), end);
    int down = lowest <= 0 ? 0 : (lowest >= end ? LEG_CELLS : LEG_CELLS / 2);
    RayMap falling = piece_map(ray, real(0), lowest, true);
    RayMap rising = piece_map(ray, lowest, end, false);
    leg.depth = vec3(real(0));
    leg.at[0] = real(0);
    leg.extinction[0] = medium_extinction(altitude);
    leg.lit[0] = lights ? rough_light(walk, altitude, walk.up, only) : vec3(real(0));
    int k = 1;
    do {  // tested at the end: see march.glsl
        real t = k <= down ? lowest - map_distance(falling, 1 - real(k) / real(max(down, 1)))
                           : lowest + map_distance(rising, real(k - down) / real(max(LEG_CELLS - down, 1)));
        leg.at[k] = k == LEG_CELLS ? end : clamp(t, leg.at[k - 1], end);
        Walk there = walk_on(walk, leg.at[k], ground && k == LEG_CELLS);
        leg.extinction[k] = medium_extinction(there.altitude);
        leg.lit[k] = lights ? rough_light(walk, there.altitude, there.up, only) : vec3(real(0));
        leg.depth += (real(0.5) * (leg.at[k] - leg.at[k - 1])) * (leg.extinction[k - 1] + leg.extinction[k]);
        ++k;
    } while (k <= LEG_CELLS);
    return leg;
}
// To whatever comes first.
Leg leg_to_end(Walk walk, bool lights, int only) {
    bool ground = hits_ground(walk.altitude, walk.mu);
    real end = ground ? distance_to_ground(walk.altitude, walk.mu) : distance_to_top(walk.altitude, walk.mu);
    return make_leg(walk, end, ground, lights, only);
}

// Share of light that scatters or is absorbed on the leg, by the stand-in.
vec3 caught_share(Leg leg) { return leg.depth * mean_transmittance(leg.depth); }

// How far a quantity that begins as `here` and changes by `slope` a unit of length must be followed until it adds up to `wanted`.
real reach(real here, real slope, real wanted) {
    real root = sqrt(max(here * here + 2 * slope * wanted, real(0)));
    return 2 * wanted / max(here + root, real(1e-37));
}
// Density of meeting the air at a place s of a cell, 1/km: of all channels by their shares.
real caught_density(Leg leg, int k, real s, vec3 before, vec3 share, vec3 caught) {
    vec3 here = leg.extinction[k];
    vec3 slope = (leg.extinction[k + 1] - here) / max(leg.at[k + 1] - leg.at[k], real(1e-20));
    vec3 extinction = max(here + s * slope, vec3(real(0)));
    vec3 depth = before + s * (here + (real(0.5) * s) * slope);
    vec3 drawn = share * extinction * exp(-depth) / max(caught, vec3(real(1e-30)));
    return drawn.x + drawn.y + drawn.z;
}
// A channel by its share.
int draw_channel(vec3 share, real pick) {
    int channel = pick < share.x ? 0 : (pick < share.x + share.y ? 1 : 2);
    if (share[channel] <= 0) channel = share.y > 0 ? 1 : (share.x > 0 ? 0 : 2);  // a pick on the edge of nothing
    return channel;
}

struct Place {
    real t;        // distance from the leg's start
    real density;  // of this draw, 1/km; 0: none was possible
};
// Draws a place where light of these weights meets the air: a channel by what it has to lose, then its optical depth, inverted. The
// density is that of all channels together.
Place draw_place(Leg leg, vec3 weight, real even_share, real pick, real u) {
    vec3 caught = caught_share(leg);
    vec3 share = weight * caught;
    real sum = share.x + share.y + share.z;
    bool even = pick < even_share || !(sum > 0);
    share = share / max(sum, real(1e-30));
    int channel = draw_channel(share, (pick - even_share) / (1 - even_share));
    real wanted = -log(max(1 - u * caught[channel], real(1e-30)));
    int cell = even ? min(int(u * real(LEG_CELLS)), LEG_CELLS - 1) : LEG_CELLS - 1;

    Place place;
    place.t = leg.end;
    place.density = real(0);
    bool found = false;
    vec3 before = vec3(real(0));
    int k = 0;
    do {
        real width = leg.at[k + 1] - leg.at[k];
        vec3 after = before + (real(0.5) * width) * (leg.extinction[k] + leg.extinction[k + 1]);
        if (!found && (k == cell || (!even && after[channel] >= wanted))) {
            found = true;
            real slope = (leg.extinction[k + 1][channel] - leg.extinction[k][channel]) / max(width, real(1e-20));
            real rest = max(wanted - before[channel], real(0));
            real s = even ? width * fract(u * real(LEG_CELLS)) : min(reach(leg.extinction[k][channel], slope, rest), width);
            place.t = leg.at[k] + s;
            real evenly = width > 0 ? 1 / (real(LEG_CELLS) * width) : real(0);
            place.density = sum > 0 ? mix(caught_density(leg, k, s, before, share, caught), evenly, even_share) : evenly;
        }
        before = after;
        ++k;
    } while (k < LEG_CELLS);
    return place;
}

// Light on its way along the leg at the ends of the cells, by the stand-in, with these weights of the channels, and its integral:
// cells as trapezia.
struct LegLight {
    real at[LEG_CELLS + 1];
    real whole;
};
LegLight light_of(Leg leg, vec3 weight) {
    LegLight light;
    light.at[0] = dot(weight, leg.lit[0]);
    light.whole = real(0);
    vec3 depth = vec3(real(0));
    int k = 0;
    do {
        real half_width = real(0.5) * (leg.at[k + 1] - leg.at[k]);
        depth += half_width * (leg.extinction[k] + leg.extinction[k + 1]);
        light.at[k + 1] = dot(weight * exp(-depth), leg.lit[k + 1]);
        light.whole += half_width * (light.at[k] + light.at[k + 1]);
        ++k;
    } while (k < LEG_CELLS);
    return light;
}
// Draws a place to take light from: a cell by its trapezium, and in it by the straight line between its ends; up to one time in
// four as the path meets the air, the more the thicker cells are: there light ends long before the next cell does.
CONST(real, AIR_SHARE, real(0.25))
Place draw_lit_place(Leg leg, LegLight light, vec3 weight, real pick, real u) {
    vec3 caught = caught_share(leg);
    vec3 share = weight * caught;
    real sum = share.x + share.y + share.z;
    share = share / max(sum, real(1e-30));
    bool lit = light.whole > 0;
    real cell_depth = max(leg.depth.x, max(leg.depth.y, leg.depth.z)) / real(LEG_CELLS);
    real air_share = sum > 0 ? (lit ? AIR_SHARE * (1 - exp(-cell_depth)) : real(1)) : real(0);
    bool even = pick < EVEN_SHARE || !(lit || sum > 0);
    real p = (pick - EVEN_SHARE) / (1 - EVEN_SHARE);
    bool by_air = p < air_share;
    int channel = draw_channel(share, p / max(air_share, real(1e-20)));
    real wanted = by_air ? -log(max(1 - u * caught[channel], real(1e-30))) : u * light.whole;
    int cell = even ? min(int(u * real(LEG_CELLS)), LEG_CELLS - 1) : LEG_CELLS - 1;
    Place place;
    place.t = leg.end;
    place.density = real(0);
    bool found = false;
    vec3 depth = vec3(real(0));
    real before = real(0);
    int k = 0;
    do {
        real width = leg.at[k + 1] - leg.at[k];
        // What adds up to what is wanted: the channel's extinction, or light.
        real here = by_air ? leg.extinction[k][channel] : light.at[k];
        real next = by_air ? leg.extinction[k + 1][channel] : light.at[k + 1];
        real after = before + real(0.5) * width * (here + next);
        if (!found && (k == cell || (!even && after >= wanted))) {
            found = true;
            // A share x of the cell holds here x + (next - here) x^2 / 2 of it.
            real rest = max(wanted - before, real(0)) / max(width, real(1e-20));
            real x = even ? fract(u * real(LEG_CELLS)) : min(reach(here, next - here, rest), real(1));
            place.t = leg.at[k] + x * width;
            real evenly = width > 0 ? 1 / (real(LEG_CELLS) * width) : real(0);
            real drawn = air_share > 0 ? air_share * caught_density(leg, k, x * width, depth, share, caught) : real(0);
            if (lit) drawn += (1 - air_share) * mix(light.at[k], light.at[k + 1], x) / light.whole;
            place.density = lit || sum > 0 ? mix(drawn, evenly, EVEN_SHARE) : evenly;
        }
        before = after;
        depth += (real(0.5) * width) * (leg.extinction[k] + leg.extinction[k + 1]);
        ++k;
    } while (k < LEG_CELLS);
    return place;
}

#endif
