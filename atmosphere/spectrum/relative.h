// For tests of numbers as small as cross-sections, where doctest's Approx, which always allows for an absolute error too, would
// let everything pass.
#pragma once

#include <cmath>

namespace aureole::spectrum::detail {

/// Distance from what is expected, as a share of it.
[[nodiscard]] inline double relative(double actual, double expected) {
    return std::abs(actual - expected) / std::abs(expected);
}

}  // namespace aureole::spectrum::detail
