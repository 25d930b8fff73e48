// How the moments of the multi-scatter table are counted (multi_scatter.glsl says what they are).
#ifndef AUREOLE_MOMENTS_GLSL
#define AUREOLE_MOMENTS_GLSL

// Pairs (l, m) with 0 <= m <= l <= order.
int moments_up_to(int order) { return (order + 1) * (order + 2) / 2; }

#endif
