// N wavelengths in place of red, green and blue, for every model.
//
// Where a model's sky comes from tables (aureole, bruneton, hillaire without a march), these are made for every three
// wavelengths of a set, and added up into tables in linear Rec.709; composite and light read those, and cost what they cost in
// RGB. Models that compute light for each pixel do so for every three wavelengths: composite and light run as often, and add
// up. See models/spectral/spectral.md.
//
//     const auto set = spectrum::fitted(4);
//     Atmosphere air(device, presets::earth(), models::spectral(models::aureole(), {.wavelengths = set}));
//     sun.irradiance = models::solar_rec709(set);  // pictures in cd/m^2
#pragma once

#include <aureole/model.h>
#include <aureole/spectrum.h>

#include <functional>
#include <string_view>

namespace aureole::models {

/// The air that `rgb` stands for, at three wavelengths (360-830 nm), in the places of red, green and blue. Planet, profiles and
/// phase functions stay. `rgb` counts as the air at 680, 550 and 440 nm, as in the presets. By name:
///   "rayleigh": scattering falls as that of molecules does, spectrum::rayleigh_scattering, fitted to the three (least squares
///   of
///               the logarithms), if they are no further than 20 % from it;
///   "ozone":    absorption is that of spectrum::ozone_cross_section, with the sum of the three;
/// every other coefficient, and scattering that is no molecules', goes through the three: as a power of the wavelength between
/// two of them, and beyond them with the exponent of the nearer two, at most 5 either way; where one of them is 0, linear, and
/// constant beyond them. The albedo of the ground is linear, and constant beyond them. A wavelength out of range is
/// Error(invalid_argument).
[[nodiscard]] AtmosphereParameters at_wavelengths(const AtmosphereParameters& rgb, const std::array<double, 3>& nm);

/// Linear Rec.709 of the sun itself: the sum of the weights. As Sun::irradiance it makes pictures in cd/m^2 (times the square
/// of 1 au over the distance to the sun). With (1, 1, 1) the sun is white.
[[nodiscard]] Rgb solar_rec709(const spectrum::Wavelengths& wavelengths);

/// A model in wavelengths: which, and the air at them.
struct SpectralSettings {
    /// 1 to 42 of them, with weights in [-1e30, 1e30] whose sum is at least 1e-30 in every channel.
    spectrum::Wavelengths wavelengths = spectrum::fitted(4);
    /// The atmosphere's parameters at three wavelengths; none: at_wavelengths. May differ from the atmosphere's own in
    /// coefficients and profiles, and in the albedo of the ground; radii and phase functions must be the same, else
    /// Error(invalid_argument) from Atmosphere's constructor or set_parameters. What it throws comes from there too.
    std::function<AtmosphereParameters(const AtmosphereParameters& rgb, const std::array<double, 3>& nm)> air{};
};
/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const SpectralSettings& settings);

/// `inner` in these wavelengths, under its own name. Error(invalid_argument) if it is null, or in wavelengths already. One
/// triplet with a diagonal matrix is shown as it is, as without this.
[[nodiscard]] ModelPtr spectral(const ModelPtr& inner, const SpectralSettings& settings = {});

/// Settings by a word, for programs: "3", "4", "6": fitted; any other number in [3, 42]: equal bins; throws
/// Error(invalid_argument) naming the field "spectral" otherwise. "rgb", which needs no settings, is the caller's.
[[nodiscard]] spectrum::Wavelengths wavelengths_by_name(std::string_view name);

}  // namespace aureole::models
