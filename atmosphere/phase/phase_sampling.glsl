// Random cosines of scattering angles, distributed nearly as phase functions are, and their exact densities. Needs `atm`.
#ifndef AUREOLE_PHASE_SAMPLING_GLSL
#define AUREOLE_PHASE_SAMPLING_GLSL

#include "phase/phase.glsl"

// Inverse of Rayleigh's cumulative distribution: with q = 4 u - 2, nu^3 + 3 nu = 2 q, whose one real root is A - 1 / A,
// A^3 = q + sqrt(q^2 + 1) (Cardano).
real sample_rayleigh(real u) {
    real q = 4 * u - 2;
    real a = pow(q + sqrt(q * q + 1), real(1) / real(3));
    return clamp(a - 1 / a, real(-1), real(1));
}

// Inverse of Henyey-Greenstein's: nu = (1 + g^2 - ((1 - g^2) / (1 + g x))^2) / (2 g) with x = 2 u - 1, multiplied out so that g may
// vanish.
real sample_henyey_greenstein(real g, real u) {
    real x = 2 * u - 1;
    real d = 1 + g * x;
    real n = x * (1 + g * g) + g * (real(0.5) * (x * x + 3) + real(0.5) * g * g * (x * x - 1));
    return clamp(n / (d * d), real(-1), real(1));
}

// Stands in for a phase function that has no simple inverse: a mixture of three Henyey-Greenstein lobes of asymmetry x, y, z. The
// quotient of the true phase function and the mixture is bounded for all of them.
struct PhaseLobes {
    vec3 g;
    vec2 weight;  // of the first two
};
// Cornette-Shanks and Draine are Henyey-Greenstein times a factor between its least and 1 + alpha times that. Of a table, the first
// moment says how wide it is, the eleventh (g^11 of a Henyey-Greenstein lobe) how sharp its peak.
PhaseLobes phase_lobes(int c) {
    int kind = phase_kind(c);
    vec4 parameters = atm.phase_parameters[c];
    PhaseLobes lobes;
    lobes.g = vec3(parameters.x, real(0), real(0));
    lobes.weight = vec2(real(1), real(0));
    if (kind == PHASE_HG_DRAINE) {
        lobes.g.y = parameters.y;
        lobes.weight = vec2(1 - parameters.w, parameters.w);
    }
    if (kind == PHASE_TABULATED) {
        real peak = max(atm.phase_moments[3 * c + 2].w, real(1e-12));
        lobes.g = vec3(clamp(atm.phase_moments[3 * c].y, real(-0.95), real(0.95)), min(pow(peak, real(1) / real(11)), real(0.98)), real(0));
        lobes.weight = vec2(real(0.5), real(0.25));
    }
    return lobes;
}

// A cosine for phase function c from two even numbers.
real sample_phase(int c, real pick, real u) {
    if (phase_kind(c) == PHASE_RAYLEIGH) return sample_rayleigh(u);
    PhaseLobes lobes = phase_lobes(c);
    real g = pick < lobes.weight.x ? lobes.g.x : (pick < lobes.weight.x + lobes.weight.y ? lobes.g.y : lobes.g.z);
    return sample_henyey_greenstein(g, u);
}
// Its density by solid angle, 1/sr.
real sampled_phase_density(int c, real nu) {
    if (phase_kind(c) == PHASE_RAYLEIGH) return rayleigh_phase(nu);
    PhaseLobes lobes = phase_lobes(c);
    return lobes.weight.x * henyey_greenstein_phase(lobes.g.x, nu) + lobes.weight.y * henyey_greenstein_phase(lobes.g.y, nu) +
           (1 - lobes.weight.x - lobes.weight.y) * henyey_greenstein_phase(lobes.g.z, nu);
}

#endif
