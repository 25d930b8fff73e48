// A slab of constant air.
#ifndef AUREOLE_SLAB_GLSL
#define AUREOLE_SLAB_GLSL

// (1 - exp(-x)) / x, the mean transmittance within a slab of optical depth x; its series where the quotient would cancel: at 1/4
// the one loses two bits of a float, and the other leaves out 1.5e-9.
vec3 mean_transmittance(vec3 x) {
    vec3 one = vec3(real(1));
    // Products with 1/n, folded when compiled: a division takes several times as long on a processor's vectors.
    vec3 series = one - x * (real(1) / real(7));
    series = one - x * (real(1) / real(6)) * series;
    series = one - x * (real(1) / real(5)) * series;
    series = one - x * (real(1) / real(4)) * series;
    series = one - x * (real(1) / real(3)) * series;
    series = one - x * (real(1) / real(2)) * series;
    vec3 quotient = (one - exp(-x)) / max(x, vec3(real(1e-3)));
    return mix(quotient, series, lessThan(x, vec3(real(0.25))));
}

#endif
