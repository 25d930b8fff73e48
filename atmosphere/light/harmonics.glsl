// Real spherical harmonics up to degree 2, orthonormal, in the order 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22, and the irradiance that
// their coefficients give a surface.
#ifndef AUREOLE_HARMONICS_GLSL
#define AUREOLE_HARMONICS_GLSL

#include "common/constants.glsl"

CONST(int, HARMONIC_COUNT, 9)

real world_harmonic(int i, vec3 d) {
    if (i == 0) return real(0.28209479177387814);                                // 1 / (2 sqrt(pi))
    if (i == 1) return real(0.48860251190291992) * d.y;                          // sqrt(3 / (4 pi))
    if (i == 2) return real(0.48860251190291992) * d.z;
    if (i == 3) return real(0.48860251190291992) * d.x;
    if (i == 4) return real(1.0925484305920790) * d.x * d.y;                     // sqrt(15 / (4 pi))
    if (i == 5) return real(1.0925484305920790) * d.y * d.z;
    if (i == 6) return real(0.31539156525252001) * (3 * d.z * d.z - 1);          // sqrt(5 / (16 pi))
    if (i == 7) return real(1.0925484305920790) * d.x * d.z;
    return real(0.54627421529603953) * (d.x * d.x - d.y * d.y);                  // sqrt(15 / (16 pi))
}

// What the cosine lobe of a surface does to degree l: pi, 2 pi / 3, pi / 4 (Ramamoorthi & Hanrahan 2001, equation 8).
real cosine_lobe(int i) {
    if (i == 0) return PI;
    return i < 4 ? 2 * PI / 3 : PI / 4;
}

// Irradiance that a coefficient of 1 gives a surface of this normal.
real harmonic_irradiance(int i, vec3 normal) { return cosine_lobe(i) * world_harmonic(i, normal); }

#endif
