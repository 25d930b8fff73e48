// Ready-made atmospheres. Each states its source.
#pragma once

#include <aureole/parameters.h>

#include <string_view>

namespace aureole::presets {

/// Earth, clear: radii 6360/6460 km; Rayleigh (5.802, 13.558, 33.1)e-6 /m, scale height 8 km; Mie scattering 3.996e-6,
/// absorption 0.444e-6 /m, scale height 1.2 km, Cornette-Shanks g 0.8; ozone (0.650, 1.881, 0.085)e-6 /m, tent 10-25-40 km.
/// Hillaire, EGSR 2020, after Bruneton 2017.
[[nodiscard]] AtmosphereParameters earth();
/// Earth with ten times the aerosol, g 0.76, ground albedo 0.1.
[[nodiscard]] AtmosphereParameters hazy_earth();
/// Mars with its dust: radii 3389.5/3509.5 km; Rayleigh (19.918, 13.57, 5.75)e-6 /m and dust 9.66e-6 scattering,
/// (0.5, 1.3, 3.8)e-6 absorption, both with scale height 11.1 km; Cornette-Shanks g 0.76; albedo 0.25.
[[nodiscard]] AtmosphereParameters mars();
/// A body without air, radii of the Moon (1737.4 km).
[[nodiscard]] AtmosphereParameters airless();

/// By name: "earth", "hazy_earth", "mars", "airless". Anything else throws Error naming the four.
[[nodiscard]] AtmosphereParameters by_name(std::string_view name);

}  // namespace aureole::presets
