// A leg of a path: a straight line through the air to the ground, to the top or to a given end, on which a place to scatter is drawn.
//
// The place is drawn from a stand-in for the air: extinction at the ends of LEG_CELLS cells, linear between them, whose optical depth
// is a parabola in each cell and therefore easily inverted. A path weighs what is true divided by the density of what was drawn, so
// the stand-in makes noise at worst, never an error; the true transmittance comes from quadrature (transmittance/column.glsl). So that
// air which the stand-in overlooks between two of its nodes is met too, one place in sixteen is drawn evenly over the cells.
#ifndef AUREOLE_LEG_GLSL
#define AUREOLE_LEG_GLSL

#include "common/march.glsl"

CONST(int, LEG_CELLS, 16)
CONST(real, EVEN_SHARE, real(0.0625))

struct Leg {
    real altitude, mu;             // of its start
    real end;                      // length, km
    bool ground;                   // ends on the ground
    real at[LEG_CELLS + 1];        // distances of the cells' ends
    vec3 extinction[LEG_CELLS + 1];
    vec3 depth;                    // optical depth of the whole, by the stand-in
};

// Cells are short where the air is dense; one ends at the lowest point.
Leg make_leg(real altitude, real mu, real end, bool ground) {
    Leg leg;
    leg.altitude = altitude;
    leg.mu = mu;
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
    int k = 1;
    do {  // tested at the end: see march.glsl
        real t = k <= down ? lowest - map_distance(falling, 1 - real(k) / real(max(down, 1)))
                           : lowest + map_distance(rising, real(k - down) / real(max(LEG_CELLS - down, 1)));
        leg.at[k] = k == LEG_CELLS ? end : clamp(t, leg.at[k - 1], end);
        leg.extinction[k] = medium_extinction(altitude_after(altitude, mu, leg.at[k]));
        leg.depth += (real(0.5) * (leg.at[k] - leg.at[k - 1])) * (leg.extinction[k - 1] + leg.extinction[k]);
        ++k;
    } while (k <= LEG_CELLS);
    return leg;
}
// From a point in the air to whatever comes first.
Leg leg_to_end(real altitude, real mu) {
    bool ground = hits_ground(altitude, mu);
    return make_leg(altitude, mu, ground ? distance_to_ground(altitude, mu) : distance_to_top(altitude, mu), ground);
}

// Share of light that scatters or is absorbed on the leg, by the stand-in.
vec3 caught_share(Leg leg) { return leg.depth * mean_transmittance(leg.depth); }

struct Place {
    real t;        // distance from the leg's start
    real density;  // of this draw, 1/km; 0: none was possible
};
// Draws a place where light of these weights meets the air: a channel by what it has to lose, then its optical depth, inverted. The
// density is that of all channels together.
Place draw_place(Leg leg, vec3 weight, real pick, real u) {
    vec3 caught = caught_share(leg);
    vec3 share = weight * caught;
    real sum = share.x + share.y + share.z;
    bool even = pick < EVEN_SHARE || !(sum > 0);
    share = share / max(sum, real(1e-30));
    real p = (pick - EVEN_SHARE) / (1 - EVEN_SHARE);
    int channel = p < share.x ? 0 : (p < share.x + share.y ? 1 : 2);
    if (share[channel] <= 0) channel = share.y > 0 ? 1 : (share.x > 0 ? 0 : 2);  // a pick on the edge of nothing
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
        vec3 here = leg.extinction[k];
        vec3 slope = (leg.extinction[k + 1] - here) / max(width, real(1e-20));
        vec3 after = before + (real(0.5) * width) * (here + leg.extinction[k + 1]);
        if (!found && (k == cell || (!even && after[channel] >= wanted))) {
            found = true;
            real rest = max(wanted - before[channel], real(0));
            real root = sqrt(max(here[channel] * here[channel] + 2 * slope[channel] * rest, real(0)));
            real s = even ? width * fract(u * real(LEG_CELLS)) : min(2 * rest / max(here[channel] + root, real(1e-30)), width);
            place.t = leg.at[k] + s;
            vec3 extinction = max(here + s * slope, vec3(real(0)));
            vec3 depth = before + s * (here + (real(0.5) * s) * slope);
            vec3 drawn = share * extinction * exp(-depth) / max(caught, vec3(real(1e-30)));
            real evenly = width > 0 ? 1 / (real(LEG_CELLS) * width) : real(0);
            place.density = sum > 0 ? mix(drawn.x + drawn.y + drawn.z, evenly, EVEN_SHARE) : evenly;
        }
        before = after;
        ++k;
    } while (k < LEG_CELLS);
    return place;
}

#endif
