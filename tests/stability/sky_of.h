// A case's sky as a model shows it, and how far two of them are apart.
#pragma once

#include "physics/sky.h"
#include "stability/cases.h"
#include "stability/rungs.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aureole::stability {

inline double brightest(const std::vector<Rgb>& seen) {
    double most = 0;
    for (const Rgb& v : seen) most = std::max({most, v.r, v.g, v.b});
    return most;
}

/// The largest difference, relative to the brighter of the two or a share of the brightest of all. Night is what half
/// floats end at.
inline double apart(const std::vector<Rgb>& a, const std::vector<Rgb>& b, double share) {
    const double least = share * std::max(brightest(a), brightest(b)) + 1e-10;
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[i][c] - b[i][c]) / std::max({a[i][c], b[i][c], least}));
    return worst;
}

inline bool sound(const std::vector<Rgb>& seen) {
    return std::ranges::all_of(seen,
                               [](const Rgb& v) { return v.r >= 0 && v.g >= 0 && v.b >= 0 && std::isfinite(v.r + v.g + v.b); });
}

/// Zenith angle of the ground's horizon at an altitude.
inline double horizon_zenith(double radius_m, double altitude_m) {
    const double h = std::max(altitude_m, 0.0);
    return physics::pi / 2 + std::atan2(std::sqrt(h * (2 * radius_m + h)), radius_m);
}

}  // namespace aureole::stability
