// A part of a 4D table, by altitude: what one dispatch computes where the work is spread over frames.
#ifndef AUREOLE_BRUNETON_SLICES_GLSL
#define AUREOLE_BRUNETON_SLICES_GLSL

struct Slices {
    vec4 first;  // x: the first slice of this dispatch
};
PUSH_CONSTANTS(Slices, slices)

int first_slice() { return int(slices.first.x); }

#endif
