// Phase functions without their sharp peaks, for integrals over a few directions. Needs `atm`.
#ifndef AUREOLE_SMOOTH_PHASE_GLSL
#define AUREOLE_SMOOTH_PHASE_GLSL

SPEC_INT(14, SHARPEST_DEGREE, 3)  // at most 11

// The phase function cut off after Legendre degree SHARPEST_DEGREE: sum (2 l + 1) / (4 pi) p_l P_l(nu). Higher degrees hardly
// reach the low moments that are wanted of the result, but a sharp peak between two directions would be missed or counted
// double. May be slightly negative away from the peak.
real smooth_phase(int c, real nu) {
    real p_before = real(1);
    real p = nu;
    real sum = real(1);
    for (int l = 1; l <= SHARPEST_DEGREE; ++l) {
        sum += real(2 * l + 1) * atm.phase_moments[3 * c + l / 4][l % 4] * p;
        real p_next = (real(2 * l + 1) * nu * p - real(l) * p_before) / real(l + 1);
        p_before = p;
        p = p_next;
    }
    return sum / (4 * PI);
}

#endif
