// Ready-made atmospheres. Each states its source.
#pragma once

#include <aureole/parameters.h>

#include <span>
#include <string_view>

namespace aureole::presets {

/// Earth, clear: radii 6360/6460 km; Rayleigh (5.802, 13.558, 33.1)e-6 /m, scale height 8 km; Mie scattering 3.996e-6,
/// absorption 0.444e-6 /m, scale height 1.2 km, Cornette-Shanks g 0.8; ozone (0.650, 1.881, 0.085)e-6 /m, tent 10-25-40 km.
/// Hillaire, EGSR 2020, after Bruneton 2017. Terms are named "rayleigh", "mie", "ozone", here and in the other Earths; those of
/// mars() "rayleigh" and "dust".
[[nodiscard]] AtmosphereParameters earth();
/// Earth with ten times the aerosol, g 0.76, ground albedo 0.1.
[[nodiscard]] AtmosphereParameters hazy_earth();
/// Earth with as much aerosol as this visibility takes: 1 km to 220 km; earth() itself has 166 km. Error(invalid_argument)
/// else. Visibility is the meteorological optical range (WMO-No. 8, chapter 9): where a beam of light is down to 5 %, so
/// extinction is ln 20 / visibility = 3.0 / visibility, here that of molecules and aerosol together on the ground, in green.
/// (Koschmieder's range, where contrast is down to 2 %, is 3.912 / extinction: 1.31 times as far.) The aerosol is earth()'s in
/// all but its amount: of one scale height of 1.2 km, g 0.8, and grey. Fog, below 1 km, is of droplets; and above 220 km
/// molecules alone are more.
[[nodiscard]] AtmosphereParameters earth_with_visibility(double visibility_m);
/// Mars with its dust: radii 3389.5/3509.5 km; Rayleigh (19.918, 13.57, 5.75)e-6 /m and dust 9.66e-6 scattering,
/// (0.5, 1.3, 3.8)e-6 absorption, both with scale height 11.1 km; Cornette-Shanks g 0.76; albedo 0.25.
[[nodiscard]] AtmosphereParameters mars();
/// A body without air, radii of the Moon (1737.4 km).
[[nodiscard]] AtmosphereParameters airless();

/// Earth with the density of the U.S. Standard Atmosphere 1976 in a table, Rayleigh scattering of Bodhaine 1999 at 680, 550 and
/// 440 nm and 300 Dobson units of ozone with measured cross-sections: spectrum::earth with its defaults (spectrum.h); aerosol
/// as earth().
[[nodiscard]] AtmosphereParameters us_standard_1976();
/// Titan: nitrogen, methane, and an orange haze as deep as the air. Radius 2574.7 km (Zebker et al. 2009), air to 600 km.
/// Molecules: by pressure and temperature that the Huygens probe found at the ground, 1467 hPa and 93.65 K
/// (Fulchignoni et al. 2005), 1.135e26 a cubic metre, which scatter like those of air (spectrum.h); scale height 20 km of that
/// temperature. Methane: 5.65 % of the molecules at the ground, 1.5 % from 40 km on (Niemann et al. 2010), as one exponential
/// of 12 km. Illustrative, in size and colour alone: the absorption of methane (parameters.md), the haze's optical depth (about
/// 6 in green), its scale height, albedo and phase function, and the ground's albedo.
[[nodiscard]] AtmosphereParameters titan();

/// "earth", "hazy_earth", "mars", "airless", "us_standard_1976", "titan".
[[nodiscard]] std::span<const std::string_view> names();
/// By name. Anything else throws Error naming them.
[[nodiscard]] AtmosphereParameters by_name(std::string_view name);

}  // namespace aureole::presets
