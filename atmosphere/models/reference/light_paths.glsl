// The light's directions, traced: (direction, part) of each sun. The paths of a direction are spread over parts, each an invocation's
// work; the sum of the parts is what the camera sees there. Rows: the parts of the first sun, of the second, ...
#ifndef AUREOLE_LIGHT_PATHS_GLSL
#define AUREOLE_LIGHT_PATHS_GLSL

SPEC_INT(34, LIGHT_PATHS, 8)
SPEC_INT(35, LIGHT_PARTS, 1)

#endif
