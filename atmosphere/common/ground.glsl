// Light off the ground, a Lambertian surface. Needs `atm`.
#ifndef AUREOLE_GROUND_GLSL
#define AUREOLE_GROUND_GLSL

#include "common/constants.glsl"

// Radiance of the ground under this irradiance, behind air of this optical depth.
vec3 ground_radiance(vec3 depth, vec3 irradiance) { return exp(-depth) * (vec3(atm.ground_albedo) / PI) * irradiance; }

#endif
