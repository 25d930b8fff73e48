// What no air can exceed, for tables whose numbers may: rules with a few nodes do not keep energy in air of a thousand optical depths,
// and a geometric series of orders that hardly fade makes much of little.
#ifndef AUREOLE_ENERGY_GLSL
#define AUREOLE_ENERGY_GLSL

// Mean radiance, 1/sr per unit of the sun's irradiance. Deep inside a half-space that absorbs nothing, under a sun at its zenith, it is
// sqrt(3) H(1) / (4 pi) = 0.401, with H(1) = 2.908 (Chandrasekhar 1960, sections 14 and 15, for isotropic scattering; others end within
// some per cent of it). Absorption, an end of the air, a curved or a darker ground, a lower sun leave less of it.
CONST(real, MOST_MEAN_RADIANCE, real(0.5))

#endif
