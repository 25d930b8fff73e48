// Random numbers from counters: the same place, path and draw give the same numbers on every device, in any order, in float and in
// double.
#ifndef AUREOLE_RANDOM_GLSL
#define AUREOLE_RANDOM_GLSL

// Even in (0, 1): the middles of 2^23 cells, which float and double both hold exactly.
real unit_number(uint bits) { return (real(bits >> 9) + real(0.5)) * (real(1) / real(8388608)); }

// Four numbers. PCG4D of Jarzynski & Olano 2020 (Hash Functions for GPU Rendering): a step of a linear congruential generator on each
// of the counters, then two rounds in which each is mixed with the others.
vec4 random_numbers(uint x, uint y, uint z, uint w) {
    x = x * 1664525u + 1013904223u;
    y = y * 1664525u + 1013904223u;
    z = z * 1664525u + 1013904223u;
    w = w * 1664525u + 1013904223u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    w ^= w >> 16;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return vec4(unit_number(x), unit_number(y), unit_number(z), unit_number(w));
}

// Counters of random numbers, and the next four of them. Those that tracking.glsl takes stand apart from the path's own, so that a path
// goes the same way whichever way its transmittances are found, but for choices that hang on its weight.
struct Draws {
    uint x, y, path, next;
};
vec4 next_numbers(INOUT(Draws) draws) {
    vec4 numbers = random_numbers(draws.x, draws.y, draws.path, draws.next);
    draws.next += 1u;
    return numbers;
}
Draws tracking_draws(uint x, uint y, uint path, uint seed) {
    Draws draws;
    draws.x = x;
    draws.y = y;
    draws.path = path + 2147483648u;  // paths are fewer
    draws.next = seed;
    return draws;
}

#endif
