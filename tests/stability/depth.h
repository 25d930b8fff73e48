// A path through the air of a case, and what rounding may do to its optical depth.
#pragma once

#include "stability/inputs.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace aureole::stability {

inline constexpr double km = 1e-3;
template <class real>
inline constexpr double step = static_cast<double>(std::numeric_limits<real>::epsilon());

/// The largest of the channels of a defect, as a share of its bound.
inline double share_of(const glm::dvec3& defect, const glm::dvec3& bound) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        if (!(defect[i] <= 0)) worst = std::max(worst, defect[i] / std::max(bound[i], 1e-30));
    return worst;
}

/// Of a point on a path, or on the path from a point of it on, whose cosine is rounded too (docs/stability.md, Functions).
template <class real>
double rounding_of_altitude(double radius, double h, double length) {
    return 8 * step<real> * (h + length + 0.5 * length * length / (radius + h)) + 16 * step<real> * length;
}

/// The largest step between two texels of a profile: between these, density is linear.
inline double largest_cell(const Inputs& in) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < in.profile_table.size(); ++i)
        if ((i + 1) % detail::table_width != 0)
            largest = std::max(largest, std::abs(double{in.profile_table[i + 1]} - double{in.profile_table[i]}));
    return largest;
}

/// Of one term.
template <class real, class Kernel>
glm::dvec3 depth_of_term(Kernel& k, int term, real h, real mu, real end) {
    const auto all = k.atm;
    for (int j = 0; j < k.TERM_COUNT; ++j)
        if (j != term) k.atm.term_extinction[j] = glm::vec<4, real>(0);
    const glm::dvec3 depth(k.optical_depth_along(h, mu, end));
    k.atm = all;
    return depth;
}

/// What rounding may do to the depth of a path: the altitude of each of its points is off by `off`, its end by as much. An
/// exponential multiplies that by 1 / H, a tent by 1 / half width, a table by its steepest cell (its axis is the square root of
/// altitude, and a root of a sum is no more than the sum of roots).
template <class real, class Kernel>
glm::dvec3 conditioning(Kernel& k, double cell, real h, real mu, real end) {
    const double length = end, off = rounding_of_altitude<real>(k.bottom_radius(), h, length);
    const double lowest = k.altitude_after(h, mu, std::clamp(-(k.bottom_radius() + h) * mu, real(0), end));
    glm::dvec3 sum(0);
    for (int i = 0; i < k.TERM_COUNT; ++i) {
        const glm::dvec3 extinction(k.atm.term_extinction[i]);
        const glm::dvec4 profile(k.atm.term_profile[i]);
        if (k.term_kind(i) == k.PROFILE_EXPONENTIAL)
            sum += depth_of_term(k, i, h, mu, end) * std::expm1(std::min(off * profile.x, 600.0)) +
                   extinction * (std::exp(-lowest * profile.x) * off);
        else if (k.term_kind(i) == k.PROFILE_TENT)
            sum += extinction * (length * std::min(off * profile.y, 1.0) + off);
        else
            sum +=
                extinction * (length * cell * (detail::table_width - 1) * std::sqrt(off / static_cast<double>(k.atm.tables.y)));
    }
    return sum + 32 * step<real> * glm::dvec3(k.optical_depth_along(h, mu, end));
}

/// A ray from a place in the shell to where it ends.
template <class real>
struct Path {
    template <class Kernel>
    Path(const Case& c, Kernel& k) {
        h = std::min(static_cast<real>(c.altitude_in_air_m() * km), k.shell_thickness());
        mu = std::max(static_cast<real>(std::cos(c.view_zenith())), real(-1));
        ground = k.hits_ground(h, mu);
        length = ground ? k.distance_to_ground(h, mu) : k.distance_to_top(h, mu);
    }
    real h, mu, length;
    bool ground;
};

}  // namespace aureole::stability
