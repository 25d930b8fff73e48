// Shared by the kernels of this folder; included twice by one of them, taken once.
#ifndef AUREOLE_TEST_COMMON_GLSL
#define AUREOLE_TEST_COMMON_GLSL

CONST(real, HALF, real(0.5))

struct Params {
    vec4 scale;
    mat4 transform;
};

// lo + hi is x.
void split(real x, OUT(real) lo, OUT(real) hi) {
    lo = x * HALF;
    hi = x - lo;
}

#endif
