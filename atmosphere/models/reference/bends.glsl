// How far tabulated profiles bend between their samples: what bounds them from both sides on any piece of a ray.
//
// Between two samples a table is a straight line in sqrt(altitude) (medium.glsl). A straight line in altitude between the same two
// values departs from it, at a share y of the cell [i, i + 1], by y (1 - y) / (2 i + 1) of their difference: always to one side, and at
// most by a quarter of it over 2 i + 1. Of a block of samples: the range of what all of them and the bends between them depart from
// the line in altitude between the block's ends.
#ifndef AUREOLE_BENDS_GLSL
#define AUREOLE_BENDS_GLSL

CONST(int, BEND_BLOCK, 64)  // cells of a block

// Altitude of sample i of `last` + 1, as a share of the highest.
real sample_height(int i, int last) { return (real(i) / real(last)) * (real(i) / real(last)); }

// Of the cell that begins with sample i: what the table may depart by from the line in altitude between its ends.
real cell_bend(int i, real rise) { return rise * (real(0.25) / real(2 * i + 1)); }

#endif
