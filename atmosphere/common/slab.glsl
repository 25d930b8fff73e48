// A slab of constant air.
#ifndef AUREOLE_SLAB_GLSL
#define AUREOLE_SLAB_GLSL

// (1 - exp(-x)) / x, the mean transmittance within a slab of optical depth x; its series where the quotient would cancel.
vec3 mean_transmittance(vec3 x) {
    vec3 series = vec3(real(1)) - x * (vec3(real(0.5)) - x * (real(1) / real(6)));
    vec3 quotient = (vec3(real(1)) - exp(-x)) / max(x, vec3(real(1e-3)));
    return mix(quotient, series, lessThan(x, vec3(real(1e-2))));
}

#endif
