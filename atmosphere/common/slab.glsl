// A slab of constant air.
#ifndef AUREOLE_SLAB_GLSL
#define AUREOLE_SLAB_GLSL

// (1 - exp(-x)) / x, the mean transmittance within a slab of optical depth x; its series where the quotient would cancel: at 1/4
// the one loses two bits of a float, and the other leaves out 1.5e-9.
vec3 mean_transmittance(vec3 x) {
    vec3 one = vec3(real(1));
    vec3 series = one - x / real(2) * (one - x / real(3) * (one - x / real(4) * (one - x / real(5) * (one - x / real(6) * (one - x / real(7))))));
    vec3 quotient = (one - exp(-x)) / max(x, vec3(real(1e-3)));
    return mix(quotient, series, lessThan(x, vec3(real(0.25))));
}

#endif
