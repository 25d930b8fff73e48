// What pipelines are specialized by: the structure of the air. Numbers in the air stay in uniforms, so that editing them never
// makes a pipeline. common/host_blocks.cpp packs all of them.
#ifndef AUREOLE_SPECIALIZATION_GLSL
#define AUREOLE_SPECIALIZATION_GLSL

SPEC_INT(0, TERM_COUNT, 0)   // density terms in use, 0 .. 16
SPEC_INT(1, TERM_KINDS, 0)   // profile of term i: bits 2 i and 2 i + 1 (medium.glsl)
SPEC_INT(2, TERM_PHASES, 0)  // phase function of term i: bits 2 i and 2 i + 1
SPEC_INT(3, PHASE_COUNT, 1)  // phase functions in use, 1 .. 4 (1 even if nothing scatters)
SPEC_INT(4, PHASE_KINDS, 0)  // kind of phase function c: bits 4 c .. 4 c + 3 (phase.glsl)
SPEC_INT(6, SUN_COUNT, 1)    // suns of a view

#endif
