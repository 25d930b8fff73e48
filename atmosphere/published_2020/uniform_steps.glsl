// Uniform steps along a ray, as published.
#ifndef AUREOLE_UNIFORM_STEPS_GLSL
#define AUREOLE_UNIFORM_STEPS_GLSL

// Where step i of a ray of this length ends: 3/10 into its cell. It begins at the end of the one before, the first at 0.
real uniform_step_end(real whole, int i, int steps) { return whole * (real(i) + real(0.3)) / real(steps); }

#endif
