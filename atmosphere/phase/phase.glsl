// Phase functions p(nu), 1/sr: the share of scattered light per solid angle at the angle theta from the forward direction,
// nu = cos(theta). Each integrates to 1 over the sphere.
//
// A kernel that may meet tabulated phase functions says `#define AUREOLE_PHASE_TABLE <slot>` before it includes this file; the
// texture `phase_table` is then declared here. Without it, kind PHASE_TABULATED must not occur.
#ifndef AUREOLE_PHASE_GLSL
#define AUREOLE_PHASE_GLSL

#include "common/constants.glsl"
#include "common/specialization.glsl"

// Kinds, and what the four parameters of each mean.
CONST(int, PHASE_RAYLEIGH, 0)           // none
CONST(int, PHASE_HENYEY_GREENSTEIN, 1)  // x: g
CONST(int, PHASE_CORNETTE_SHANKS, 2)    // x: g
CONST(int, PHASE_HG_DRAINE, 3)          // x: g of the Henyey-Greenstein lobe, y: g of the Draine lobe, z: alpha, w: weight of the latter
CONST(int, PHASE_TABULATED, 4)          // x: row of phase_table

// Kind of phase function c.
int phase_kind(int c) { return (PHASE_KINDS >> (4 * c)) & 15; }

// Molecules: the radiation of an induced dipole goes with the squared sine of the angle from its axis. Averaged over the
// polarization of the incoming light that is (1 + nu^2) / 2; the integral of 1 + nu^2 over the sphere is 2 pi (2 + 2/3) = 16 pi/3.
real rayleigh_phase(real nu) { return real(3) / (real(16) * PI) * (1 + nu * nu); }

// Henyey & Greenstein 1941. (1 - g^2) / (1 + g^2 - 2 g nu)^(3/2) generates sum (2 l + 1) g^l P_l(nu), so over the sphere it
// integrates to 4 pi and its Legendre moments are g^l; the mean cosine is g.
//
// 1 + g^2 - 2 g nu cancels where the lobe peaks: nu -> 1 for g -> 1, nu -> -1 for g -> -1. With a = |g| and m = nu or -nu, the
// cosine from the peak, it equals (1 - a)^2 + 2 a (1 - m): a sum of two terms that are both exact to rounding there.
real henyey_greenstein_lobe(real a, real chord2) {  // by 2 (1 - m), the squared chord of unit vectors
    real d = (1 - a) * (1 - a) + a * chord2;
    return (1 - a) * (1 + a) / (4 * PI * (d * sqrt(d)));
}
real henyey_greenstein_phase(real g, real nu) {
    real m = g < 0 ? -nu : nu;
    return henyey_greenstein_lobe(abs(g), 2 * (1 - m));
}

// Draine 2003: Henyey-Greenstein times 1 + alpha nu^2. Since nu^2 = (1 + 2 P_2(nu)) / 3 and the l = 2 moment of Henyey-Greenstein
// is g^2, the product integrates to 1 + alpha (1 + 2 g^2) / 3: divide by that.
// With nu^3 = (3 P_1 + 2 P_3) / 5 the mean cosine is (g + alpha (3 g + 2 g^3) / 5) / (1 + alpha (1 + 2 g^2) / 3).
real draine_phase(real g, real alpha, real nu) {
    return henyey_greenstein_phase(g, nu) * (1 + alpha * (nu * nu)) / (1 + alpha * (1 + 2 * (g * g)) / 3);
}

// Cornette & Shanks 1992, (3/2) (1 + nu^2) / (2 + g^2) times Henyey-Greenstein: Draine's with alpha = 1.
real cornette_shanks_phase(real g, real nu) { return draine_phase(g, real(1), nu); }

#ifdef AUREOLE_PHASE_TABLE
SAMPLER_2D(AUREOLE_PHASE_TABLE, phase_table)

// Linear in theta between the texels of one row: texel 0 is theta = 0, the last one theta = pi. Two fetches rather than a
// filtered one: 32-bit filtering is an optional feature, its weights are coarse on many devices, and rows must not mix.
// theta comes from atan, which devices must compute far better than acos near nu = 1.
real tabulated_phase(real row, real nu) {
    int last = textureSize(phase_table, 0).x - 1;
    real theta = atan(sqrt(max((1 - nu) * (1 + nu), real(0))), nu);
    real x = theta / PI * real(last);
    int i = clamp(int(x), 0, last - 1);
    real p0 = texelFetch(phase_table, ivec2(i, int(row)), 0).x;
    real p1 = texelFetch(phase_table, ivec2(i + 1, int(row)), 0).x;
    return mix(p0, p1, clamp(x - real(i), real(0), real(1)));
}
#endif

// Any of them.
real phase_function(int kind, vec4 parameters, real nu) {
#ifdef AUREOLE_PHASE_TABLE
    if (kind == PHASE_TABULATED) return tabulated_phase(parameters.x, nu);
#endif
    if (kind == PHASE_HENYEY_GREENSTEIN) return henyey_greenstein_phase(parameters.x, nu);
    if (kind == PHASE_CORNETTE_SHANKS) return cornette_shanks_phase(parameters.x, nu);
    if (kind == PHASE_HG_DRAINE)
        return mix(henyey_greenstein_phase(parameters.x, nu), draine_phase(parameters.y, parameters.z, nu), parameters.w);
    return rayleigh_phase(nu);
}

// Phase function c of the air: needs `atm`.
real phase_value(int c, real nu) { return phase_function(phase_kind(c), atm.phase_parameters[c], nu); }

#endif
