// Light by wavelength: tables of sun, ozone and eye, formulas of the air, and what N wavelengths add up to as a colour.
//
// The models hold three numbers a texel. Three wavelengths fit into them as well as red, green and blue do: an atmosphere made
// by `spectrum::earth` for three wavelengths, rendered with a sun of irradiance 1, gives the radiance of each per unit of solar
// irradiance. Render every triplet of a set, multiply by the triplet's matrix, add: linear Rec.709 in cd/m^2.
//
// Wavelengths are in nanometres of vacuum. Tables reach from 360 to 830 nm; what lies outside is rejected with
// Error(invalid_argument), as is every other value outside the range stated.
#pragma once

#include <aureole/parameters.h>

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace aureole::spectrum {

inline constexpr double first_nm = 360, last_nm = 830;  ///< Wavelengths that the tables cover.

// ---- Tables. At a wavelength: linear between bin centres or samples. Of a band: the mean over it, from whole bins. ----

/// Of the sun, at 1 au, outside the air, W/(m^2 nm). 10 nm bins. ASTM G-173 (column ETR), which follows ASTM E-490.
[[nodiscard]] double solar_irradiance(double nm);
[[nodiscard]] double solar_irradiance(double from_nm, double to_nm);
/// Absorption of an ozone molecule at 233 K, m^2. 10 nm bins. Gorshelev et al. and Serdyuchenko et al. 2014, IUP Bremen (2011).
[[nodiscard]] double ozone_cross_section(double nm);
[[nodiscard]] double ozone_cross_section(double from_nm, double to_nm);
/// (x, y, z) of the CIE 1931 2-degree observer. Samples every 5 nm. CIE 15.
[[nodiscard]] glm::dvec3 colour_matching(double nm);
[[nodiscard]] glm::dvec3 colour_matching(double from_nm, double to_nm);

// ---- Molecules: Bodhaine et al. 1999, J. Atmos. Oceanic Technol. 16, 1854. Dry air; nm in [230, 1690], co2_ppm in [0, 1e6].
// ----

/// Molecules in a cubic metre of air at 288.15 K and 1013.25 hPa: sea level of the standard atmosphere.
inline constexpr double standard_number_density = 2.546899e25;

/// n - 1 at that density. Peck & Reeder 1972 (their range is the one of nm), with CO2 after Edlen.
[[nodiscard]] double refractivity(double nm, double co2_ppm = 360);
/// Depolarization's part in the cross-section, about 1.05.
[[nodiscard]] double king_factor(double nm, double co2_ppm = 360);
/// Scattering of a molecule, m^2.
[[nodiscard]] double rayleigh_cross_section(double nm, double co2_ppm = 360);
/// The same of a cubic metre at `standard_number_density`, 1/m.
[[nodiscard]] double rayleigh_scattering(double nm, double co2_ppm = 360);

/// Optical depth of an aerosol column, beta (nm / 1000)^-alpha: Angstrom 1929. nm in [100, 1e5], beta in [0, 1e3], alpha in
/// [-4, 4].
[[nodiscard]] double angstrom_optical_depth(double nm, double beta, double alpha);

// ---- Colour ----

/// Mean values in bands of any width. Parts outside 360-830 nm are invisible.
struct Bands {
    std::vector<double> edge_nm;  ///< Strictly increasing, in [0, 1e6]; one more than values, 2 to 4097.
    std::vector<double> value;    ///< Radiance in W/(m^2 sr nm), or irradiance in W/(m^2 nm). In [-1e100, 1e100].
};
/// Tristimulus with 683 lm/W: y is the luminance in cd/m^2 of a radiance, or the illuminance in lux of an irradiance.
[[nodiscard]] glm::dvec3 xyz(const Bands& bands);

/// Between XYZ and linear Rec.709 (ITU-R BT.709 primaries, white D65 at x 0.3127, y 0.3290). Any finite values; colours outside
/// the gamut have negative parts.
[[nodiscard]] Rgb rec709_from_xyz(const glm::dvec3& xyz);
[[nodiscard]] glm::dvec3 xyz_from_rec709(const Rgb& rgb);  ///< The inverse.
/// XYZ of Rec.709's white (1, 1, 1): D65 with y = 1.
[[nodiscard]] glm::dvec3 white_d65();

/// CIE 1976 L*a*b*. `white` in [1e-100, 1e100].
[[nodiscard]] glm::dvec3 lab_from_xyz(const glm::dvec3& xyz, const glm::dvec3& white);
/// CIEDE2000 between two L*a*b* colours: Sharma, Wu & Dalal 2005.
[[nodiscard]] double delta_e_2000(const glm::dvec3& lab_a, const glm::dvec3& lab_b);

// ---- N wavelengths ----

/// Wavelengths to render, and how they add up: linear Rec.709 in cd/m^2 = sum of to_rec709[i] x (radiance at nm[i] per unit of
/// solar irradiance). The sun's spectrum, the observer and 683 lm/W are in the weights.
struct Wavelengths {
    std::vector<double> nm;      ///< Their wavelengths.
    std::vector<Rgb> to_rec709;  ///< Weight of each in red, green and blue.
};
/// Centres of n equal bins over 380-780 nm. n in [1, 400]. Forty are the tables' own bins.
[[nodiscard]] Wavelengths equal_bins(int n);
/// The n wavelengths whose colours of sun and sky come closest to those of forty: n is 3, 4 or 6. By a fit to spectra from noon
/// to nautical twilight; how close: spectrum.md.
[[nodiscard]] Wavelengths fitted(int n);

/// Three of them, as a model renders them: nm for r, g and b, and rgb = to_rec709 * radiance.
struct Triplet {
    std::array<double, 3> nm;  ///< Their wavelengths.
    glm::dmat3 to_rec709;      ///< From radiance at the three to scene-linear Rec.709.
};
/// All of them in order. Where the last triplet has places left over, they repeat its last wavelength with weight 0.
[[nodiscard]] std::vector<Triplet> triplets(const Wavelengths& wavelengths);

// ---- The air of the Earth ----

/// Density of the U.S. Standard Atmosphere 1976 over geometric altitude, 1 at sea level, every 100 m to 100 km. Above 84.852
/// geopotential km it stays isothermal (the standard's own density at 100 km is 3 % less).
[[nodiscard]] TabulatedProfile standard_atmosphere_1976();

/// What `earth` is made of. The defaults are those of presets::earth, where that has them.
struct EarthAir {
    Profile molecules = standard_atmosphere_1976();  ///< 1 where the air is as dense as at standard sea level.
    double co2_ppm = 360;                            ///< In [0, 1e6].
    double ozone_dobson = 300;                       ///< Column, in [0, 1e4].
    TentProfile ozone{};                             ///< How it is spread.
    double aerosol_beta = 5.328e-3;                  ///< Optical depth of the aerosol column at 1 um, in [0, 1e3].
    double aerosol_alpha = 0;                        ///< Angstrom's exponent, in [-4, 4]; 1.3 on land. Bruneton 2017: 0.
    double aerosol_scale_height_m = 1200;            ///< In [0.01, 1e12].
    double aerosol_albedo = 0.9;                     ///< Scattered share of extinction, in [0, 1].
    double aerosol_g = 0.8;                          ///< Of the Cornette-Shanks phase function, in [-0.999, 0.999].
    double ground_albedo = 0.3;                      ///< In [0, 1], of every wavelength.
};
/// The atmosphere at three wavelengths (360-830 nm), in the places of red, green and blue. Radii as presets::earth: 6360 and
/// 6460 km. Terms: "rayleigh", "mie", "ozone".
[[nodiscard]] AtmosphereParameters earth(const std::array<double, 3>& nm, const EarthAir& air = {});

}  // namespace aureole::spectrum
