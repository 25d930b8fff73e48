// What a row of a table of truth says of a radiance, for the application and for the tests whose figures are to be the same.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace aureole::app {

using Channels = std::array<double, 3>;  ///< Red, green, blue.

/// A row whose standard error is above this share of its radiance, in any channel, says nothing.
inline constexpr double most_noise = 0.02;

/// sum |dL| / sum L over the channels. None where the truth is too noisy, and where there is nothing to be seen and nothing is
/// seen (a ray from space into space); infinite where something is seen all the same.
[[nodiscard]] inline std::optional<double> row_error(const Channels& seen, const Channels& truth, const Channels& noise) {
    double apart = 0, sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        if (noise[c] > most_noise * std::abs(truth[c])) return std::nullopt;
        apart += std::abs(seen[c] - truth[c]);
        sum += std::abs(truth[c]);
    }
    if (sum > 0) return apart / sum;
    if (apart > 0) return std::numeric_limits<double>::infinity();
    return std::nullopt;
}

}  // namespace aureole::app
