// What a table may hold. Half floats end at 65504, those of ten bits in a packed target at 64512: what is stored beyond is
// infinite, and times a weight of 0, as filters have them, no number. The host sets the constant by the format (common/pass.h).
#ifndef AUREOLE_STORAGE_GLSL
#define AUREOLE_STORAGE_GLSL

SPEC_REAL(54, LARGEST_STORED, real(64512))

vec3 storable(vec3 v) { return min(v, vec3(LARGEST_STORED)); }

#endif
