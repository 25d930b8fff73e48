// Measured data by wavelength, and integrals over them.
#pragma once

#include "quadrature/gauss_legendre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace aureole::spectrum::detail {

/// Tables start here, and colours end at the other.
inline constexpr double table_start_nm = 360, table_end_nm = 830;
inline constexpr double bin_nm = 10, sample_nm = 5;

/// The mean over each bin [360 + 10 i, 370 + 10 i] nm. The last one, 830-840, is only there to interpolate.
using Bins = std::array<double, 48>;
/// Values at 360 + 5 i nm, straight lines between them.
using Samples = std::array<glm::dvec3, 95>;

extern const Bins solar_irradiance_bins;     ///< W/(m^2 nm)
extern const Bins ozone_cross_section_bins;  ///< m^2
extern const Samples colour_matching_samples;

/// The value of the bin that holds nm in [360, 830].
[[nodiscard]] double in_bin(const Bins& bins, double nm);
/// On the straight line between bin centres; nm in [360, 830]. Below the first centre the first bin's value.
[[nodiscard]] double between_centres(const Bins& bins, double nm);
/// On the straight line between samples; nm in [360, 830].
[[nodiscard]] glm::dvec3 between_samples(const Samples& samples, double nm);

/// The integral of f(nm) from one wavelength to another, both in [360, 830]: piece by piece where the tables are smooth, by a
/// rule of four nodes, which takes the tables exactly and polynomials times them up to degree 6.
template <class F>
[[nodiscard]] auto integrate(double from_nm, double to_nm, F&& f) {
    static const aureole::detail::GaussLegendre rule = aureole::detail::gauss_legendre(4);
    auto sum = 0.0 * f(from_nm);
    for (double a = from_nm; a < to_nm;) {
        const double next = table_start_nm + sample_nm * (std::floor((a - table_start_nm) / sample_nm) + 1);
        const double b = std::min(next, to_nm);
        sum += rule.integrate(a, b, f);
        a = b;
    }
    return sum;
}

}  // namespace aureole::spectrum::detail
