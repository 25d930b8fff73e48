// Transmittance without bias, by ratio tracking between bounds that are known in closed form.
//
// A ray is cut into pieces on which altitude is monotone. On each every term's density is enclosed,
//   control(t) <= density(t) <= control(t) + excess,
// by a control whose integral is known and an excess that is proven from the profile itself. What the control lets through is its
// exponential; for the rest, places are drawn with the density R, the excess of all terms in the channel where it is largest, and each
// multiplies the channel c by 1 - (extinction_c - control_c) / R: in [0, 1] in every channel, so that colours share their places. The
// mean of the product is the transmittance of the rest (Novak, Selle & Jarosz 2014, residual ratio tracking; Georgiev & al. 2019).
// That holds for any R; the bounds hold the factors in [0, 1], and the noise down.
//
//   - Altitude along a straight line is convex: it lies below its chord by at most sag = length^2 / 8 times its greatest second
//     derivative, sin^2 / r at the lower end.
//   - Exponential: the density of the chord's altitude is the control, exp of a straight line; the truth is larger by a factor of at
//     most exp(sag / H), and nowhere larger than at the lower end. A vertical ray has no sag and is exact.
//   - Tent and table: a straight line between the densities at the ends, lowered by what the profile's corners, or samples, between
//     them depart from it downwards; the excess is what they depart from it in all. The sag adds its share of the line's fall.
//
// A piece begins as the whole, and is halved until its excess is small: most rays take a few pieces and draw no place at all.
#ifndef AUREOLE_TRACKING_GLSL
#define AUREOLE_TRACKING_GLSL

#include "common/slab.glsl"
#include "medium/medium.glsl"
#include "models/reference/bends.glsl"
#include "models/reference/random.glsl"

SAMPLER_2D(4, profile_bends)

CONST(real, SMALL_EXCESS, real(0.0625))        // optical depth: a piece of more is halved
CONST(real, SHORTEST_PIECE, real(1) / real(1024))  // of the monotone part; it is taken with whatever excess it has
CONST(int, MOST_PIECES, 1 << 13)               // never reached: twice as many as there can be
CONST(int, MOST_PLACES, 1 << 12)               // of a piece; that many only in air of no planet
CONST(real, ROUNDING, real(1e-5))              // of a density: excess that float's rounding may need
CONST(real, ALTITUDE_ROUNDING, real(2e-7))     // of an altitude in shares of the shell (geometry.glsl): the same
CONST(real, DARK, real(88))                    // optical depth behind which float has no light left

// A piece of a ray.
struct Piece {
    real first, last;  // altitudes of its ends
    real sag;          // how far the altitude may lie below the line between them
};
Piece make_piece(real span, real first, real last, real impact_squared) {
    real r = bottom_radius() + min(first, last);
    Piece piece;
    piece.first = first;
    piece.last = last;
    piece.sag = min(span * (span / (8 * r)) * min(impact_squared / (r * r), real(1)), abs(last - first));
    return piece;
}

// A term's density on a piece: the control at its ends, its mean, and by how much the density may lie above it.
struct Enclosure {
    real first, last, mean, excess;
};

real altitude_rounding() { return ALTITUDE_ROUNDING * shell_thickness(); }

Enclosure enclose_exponential(real decay, Piece piece) {
    Enclosure result;
    result.first = exp(-piece.first * decay);
    result.last = exp(-piece.last * decay);
    real dense = max(result.first, result.last);
    real fall = abs(piece.last - piece.first) * decay;
    result.mean = dense * mean_transmittance(vec3(fall)).x;
    result.excess = min(dense * (exp(min(piece.sag * decay, real(10))) - 1), abs(result.last - result.first)) +
                    dense * (ROUNDING + min(altitude_rounding() * decay, real(1)));
    return result;
}

// What a profile departs by from the line in altitude between the ends of a piece: the corners' range, that of bends between them, and
// what rounding of the altitude may make of it.
struct Departure {
    real below, above, bend_below, bend_above, rounding;
};
Departure no_departure() {
    Departure departure;
    departure.below = real(0);
    departure.above = real(0);
    departure.bend_below = real(0);
    departure.bend_above = real(0);
    departure.rounding = real(0);
    return departure;
}
void depart(Piece piece, real d0, real d1, real altitude, real density, INOUT(Departure) departure) {
    if (!(altitude > min(piece.first, piece.last) && altitude < max(piece.first, piece.last))) return;
    real x = (altitude - piece.first) / (piece.last - piece.first);
    real apart = density - mix(d0, d1, x);
    departure.below = min(departure.below, apart);
    departure.above = max(departure.above, apart);
}
Departure tent_departure(vec4 profile, Piece piece, real d0, real d1) {
    Departure departure = no_departure();
    depart(piece, d0, d1, profile.x - 1 / profile.y, real(0), departure);
    depart(piece, d0, d1, profile.x, real(1), departure);
    depart(piece, d0, d1, profile.x + 1 / profile.y, real(0), departure);
    departure.rounding = min(altitude_rounding() * profile.y, real(1));
    return departure;
}
// Of all samples between the ends if they are few, else of blocks. Ends early where more than `enough` is found.
Departure table_departure(int row, Piece piece, real d0, real d1, real enough) {
    int last = textureSize(profile_table, 0).x - 1;
    real low = min(sqrt(min(piece.first, piece.last) / atm.tables.y), real(1)) * real(last);
    real high = min(sqrt(max(piece.first, piece.last) / atm.tables.y), real(1)) * real(last);
    int stride = high - low > real(BEND_BLOCK) ? BEND_BLOCK : 1;
    // One more at either end, in case rounding has moved them.
    int begin = max(int(low) - 1, 0) / stride * stride;
    int end = min(int(high) + 2, last);
    Departure departure = no_departure();
    for (int i = begin; i < end; i += stride) {
        int next = min(i + stride, last);
        real density = texelFetch(profile_table, ivec2(next, row), 0).x;
        if (stride > 1) {
            real bend = texelFetch(profile_bends, ivec2(i / BEND_BLOCK, row), 0).x;
            departure.bend_above = max(departure.bend_above, bend);
            departure.bend_below = min(departure.bend_below, -bend);
        } else {
            real rise = density - texelFetch(profile_table, ivec2(i, row), 0).x;
            departure.bend_above = max(departure.bend_above, cell_bend(i, rise));
            departure.bend_below = min(departure.bend_below, cell_bend(i, rise));
            real width = atm.tables.y * (sample_height(next, last) - sample_height(i, last));
            departure.rounding = max(departure.rounding, abs(rise) * min(altitude_rounding() / width, real(1)));
        }
        depart(piece, d0, d1, atm.tables.y * sample_height(next, last), density, departure);
        if (departure.above - departure.below > enough) break;
    }
    return departure;
}
Enclosure enclose_line(int i, Piece piece, real enough) {
    real d0 = term_density(i, piece.first);
    real d1 = term_density(i, piece.last);
    Departure departure = term_kind(i) == PROFILE_TENT ? tent_departure(atm.term_profile[i], piece, d0, d1)
                                                       : table_departure(int(atm.term_profile[i].w), piece, d0, d1, enough);
    // Lower by the sag, the line in altitude is off by its fall over the sag.
    real sagged = (d0 - d1) * min(piece.sag / max(abs(piece.last - piece.first), real(1e-20)), real(1)) * (piece.last > piece.first ? real(1) : real(-1));
    real below = departure.below + departure.bend_below + min(sagged, real(0));
    real above = departure.above + departure.bend_above + max(sagged, real(0));
    Enclosure result;
    result.first = d0 + below;
    result.last = d1 + below;
    result.excess = above - below;
    if (min(result.first, result.last) < 0) {  // no density is
        result.first = real(0);
        result.last = real(0);
        result.excess = max(d0, d1) + above;
    }
    result.mean = real(0.5) * (result.first + result.last);
    result.excess += departure.rounding + ROUNDING * max(d0, d1);
    return result;
}
Enclosure enclose(int i, Piece piece, real enough) {
    if (term_kind(i) == PROFILE_EXPONENTIAL) return enclose_exponential(atm.term_profile[i].x, piece);
    return enclose_line(i, piece, enough);
}
// The control at a share x of the piece.
real control_density(int i, Enclosure enclosure, Piece piece, real x) {
    if (term_kind(i) == PROFILE_EXPONENTIAL) return exp(-mix(piece.first, piece.last, x) * atm.term_profile[i].x);
    return mix(enclosure.first, enclosure.last, x);
}

// Extinction on a piece: mean of the control, and the excess. That may be left unfinished where it is above `enough`, unless that is 0.
struct Bounds {
    vec3 control, excess;
};
Bounds enclose_extinction(Piece piece, real enough) {
    COUNT(2);
    Bounds bounds;
    bounds.control = bounds.excess = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) {
        vec3 extinction = vec3(atm.term_extinction[i]);
        real most = max(extinction.x, max(extinction.y, extinction.z));
        Enclosure enclosure = enclose(i, piece, enough > 0 ? enough / max(most, real(1e-20)) : real(1e30));
        bounds.control += enclosure.mean * extinction;
        bounds.excess += enclosure.excess * extinction;
    }
    return bounds;
}
// Extinction above the control at a share x of the piece, where the altitude is that.
vec3 residual_extinction(Piece piece, real x, real altitude) {
    COUNT(1);
    vec3 residual = vec3(real(0));
    for (int i = 0; i < TERM_COUNT; ++i) {
        Enclosure enclosure = enclose(i, piece, real(1e30));
        residual += (term_density(i, altitude) - control_density(i, enclosure, piece, x)) * vec3(atm.term_extinction[i]);
    }
    return residual;
}

struct Tracked {
    vec3 depth;    // of the control so far
    vec3 through;  // product of the factors
    real ahead;    // optical depth of excess to the next place
};
// One monotone part of the ray (altitude, mu): from its lower end at the distance `from` to the other at `to`.
void track_part(real altitude, real mu, real from, real to, INOUT(Draws) draws, INOUT(Tracked) tracked) {
    real span = abs(to - from);
    if (!(span > 0)) return;
    real way = to > from ? real(1) : real(-1);
    real r = bottom_radius() + altitude;
    real impact_squared = r * r * max((1 - mu) * (1 + mu), real(0));
    real at = real(0);
    real length = span;
    real first = altitude_after(altitude, mu, from);
    for (int taken = 0; taken < MOST_PIECES; ++taken) {
        length = min(length, span - at);
        bool shortest = length <= span * SHORTEST_PIECE;
        bool ends = at + length >= span;
        real last = altitude_after(altitude, mu, ends ? to : from + way * (at + length));
        Piece piece = make_piece(length, first, last, impact_squared);
        Bounds bounds = enclose_extinction(piece, shortest ? real(0) : SMALL_EXCESS / max(length, real(1e-9)));
        real most = max(bounds.excess.x, max(bounds.excess.y, bounds.excess.z));
        if (!shortest && most * length > SMALL_EXCESS) {
            length *= real(0.5);
        } else {
            tracked.depth += length * bounds.control;
            real passed = real(0);
            for (int place = 0; place < MOST_PLACES; ++place) {
                bool dark = max(tracked.through.x, max(tracked.through.y, tracked.through.z)) < real(1e-30);
                if (dark || passed + tracked.ahead >= most * length) break;
                passed += tracked.ahead;
                real t = passed / most;
                vec3 residual = residual_extinction(piece, t / length, altitude_after(altitude, mu, from + way * (at + t)));
                tracked.through *= vec3(real(1)) - residual / most;
                tracked.ahead = -log(next_numbers(draws).x);
            }
            tracked.ahead = max(tracked.ahead - (most * length - passed), real(0));
            at += length;
            first = last;
            length *= 2;
            if (ends || min(tracked.depth.x, min(tracked.depth.y, tracked.depth.z)) > DARK) break;
        }
    }
}
// An estimate of the transmittance of the first `end` km of a ray, whose mean over many draws is the truth.
vec3 tracked_transmittance(real altitude, real mu, real end, INOUT(Draws) draws) {
    Tracked tracked;
    tracked.depth = vec3(real(0));
    tracked.through = vec3(real(1));
    tracked.ahead = -log(next_numbers(draws).x);
    real lowest = clamp(-(bottom_radius() + altitude) * mu, real(0), end);
    track_part(altitude, mu, lowest, real(0), draws, tracked);
    track_part(altitude, mu, lowest, end, draws, tracked);
    return tracked.through * exp(-tracked.depth);
}

#endif
