// For tests and the fit: spectra of the sun and the clear sky as they occur from noon to nautical twilight, and how far sets of
// wavelengths are from the colours of forty.
#pragma once

#include <aureole/spectrum.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace aureole::spectrum::detail {

/// Optical depths of vertical columns at a wavelength, for 300 Dobson units.
struct Columns {
    double molecules, aerosol, ozone;
};

/// A way that light took, per unit of solar irradiance.
struct SkySpectrum {
    bool direct;                  ///< The sun itself, else the sky.
    double air_mass, ozone_mass;  ///< Columns on the way in.
    double view_mass;             ///< Columns that the line of sight looks through.
    double forward;               ///< How much more strongly aerosol scatters into the eye than molecules.
    double again;                 ///< Strength of higher orders.
    double aerosol_beta, aerosol_alpha;
    double ozone_dobson;

    [[nodiscard]] double operator()(const Columns& c) const {
        const double ozone = c.ozone * ozone_dobson / 300;
        const double arriving = std::exp(-air_mass * (c.molecules + c.aerosol) - ozone_mass * ozone);
        if (direct) return arriving;
        const double depth = c.molecules + c.aerosol;
        const double scattered = (c.molecules + forward * c.aerosol) / depth * (1 - std::exp(-view_mass * depth));
        return arriving * scattered * (1 + again * (1 - std::exp(-2 * c.molecules)));
    }
    [[nodiscard]] double operator()(double nm) const {
        constexpr double column_m = 8449;  // of the standard atmosphere, at sea-level density
        constexpr double ozone_column = 300 * 2.6867e20;
        return (*this)({.molecules = column_m * rayleigh_scattering(nm),
                        .aerosol = angstrom_optical_depth(nm, aerosol_beta, aerosol_alpha),
                        .ozone = ozone_column * ozone_cross_section(nm)});
    }
};

/// The i-th number of the van der Corput sequence, in [0, 1).
[[nodiscard]] inline double van_der_corput(unsigned i, unsigned base) {
    double result = 0, digit = 1;
    for (; i > 0; i /= base) result += (digit /= base) * (i % base);
    return result;
}

/// The i-th of an endless sequence without chance (Halton points): a third of them suns, a third day skies, a third twilights.
[[nodiscard]] inline SkySpectrum sky_spectrum(unsigned i) {
    const auto point = [i](unsigned base) { return van_der_corput(i / 3 + 1, base); };
    const auto between = [&](unsigned base, double low, double high) { return low + (high - low) * point(base); };
    const unsigned kind = i % 3;
    // More low suns than high ones: the colours are there.
    const double elevation = 90 * std::pow(point(2), 2);
    // Kasten & Young 1989, and a thin shell at 22 km.
    const double air_mass = 1 / (std::sin(glm::radians(elevation)) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
    const double at_shell = std::cos(glm::radians(elevation)) / (1 + 22.0 / 6371);
    const double ozone_mass = 1 / std::sqrt(1 - at_shell * at_shell);
    SkySpectrum s{.direct = kind == 0,
                  .air_mass = air_mass,
                  .ozone_mass = ozone_mass,
                  .view_mass = std::pow(38.0, point(5)),
                  .forward = between(7, 0.1, 8),
                  .again = between(11, 0, 1.5),
                  .aerosol_beta = 0.2 * std::pow(point(13), 2),
                  .aerosol_alpha = between(17, 0, 1.6),
                  .ozone_dobson = between(19, 200, 450)};
    if (kind == 1) s.air_mass *= point(3);  // what is scattered is scattered on the way down
    if (kind == 2) {
        // Rays that graze the ground at 2 to 40 km, and go on up: twice the mass of the horizon at most.
        s.air_mass = 76 * std::exp(-between(2, 2, 40) / 8);
        s.ozone_mass = between(3, 10, 35);
        s.aerosol_beta *= 0.1;
        s.view_mass = std::pow(10.0, point(5)) * 0.2;
    }
    return s;
}

/// Linear Rec.709 in cd/m^2.
[[nodiscard]] inline Rgb colour_of(const SkySpectrum& spectrum, const Wavelengths& wavelengths) {
    Rgb sum(0);
    for (std::size_t i = 0; i < wavelengths.nm.size(); ++i) sum += wavelengths.to_rec709[i] * spectrum(wavelengths.nm[i]);
    return sum;
}

/// CIEDE2000 between two colours, exposed so that the first has half the luminance of white (L* = 76).
[[nodiscard]] inline double difference(const Rgb& truth, const Rgb& other) {
    const glm::dvec3 true_xyz = xyz_from_rec709(truth);
    const double exposure = 0.5 / true_xyz.y;
    const glm::dvec3 white = white_d65();
    return delta_e_2000(lab_from_xyz(true_xyz * exposure, white), lab_from_xyz(xyz_from_rec709(other) * exposure, white));
}

struct Spread {
    double median, p95, worst;
};
[[nodiscard]] inline Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    return {at(0.5), at(0.95), values.back()};
}

/// Spectra that the fit sees come first in the sequence; these are others.
inline constexpr unsigned fit_count = 900, judge_count = 1500;

/// Differences of colour(spectrum) from those of forty bins, over spectra that the fit has not seen.
template <class F>
[[nodiscard]] Spread judge(F&& colour) {
    const Wavelengths forty = equal_bins(40);
    std::vector<double> differences;
    for (unsigned i = fit_count; i < fit_count + judge_count; ++i) {
        const SkySpectrum s = sky_spectrum(i);
        differences.push_back(difference(colour_of(s, forty), colour(s)));
    }
    return spread(differences);
}
[[nodiscard]] inline Spread judge_set(const Wavelengths& wavelengths) {
    return judge([&](const SkySpectrum& s) { return colour_of(s, wavelengths); });
}

}  // namespace aureole::spectrum::detail
