// One definition of quantiles, for the application and for the tests whose figures are to be the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace aureole::app {

/// Value below which a share `q` of the sorted values lies, linear between neighbours (as NumPy's default). 0 for no values.
[[nodiscard]] inline double quantile(std::span<const double> sorted, double q) {
    if (sorted.empty()) return 0;
    const double at = q * static_cast<double>(sorted.size() - 1);
    const std::size_t below = static_cast<std::size_t>(at), above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] == sorted[above] ? sorted[below] : std::lerp(sorted[below], sorted[above], at - std::floor(at));
}

}  // namespace aureole::app
