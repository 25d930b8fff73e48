// Values that are drawn at random round by round, each until its standard error is as small as wanted.
#pragma once

#include "app/tally.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

/// Fewer rounds say too little of their own scatter to stop at.
inline constexpr std::uint64_t sampling_least_rounds = 16;

struct Sampled {
    std::vector<Estimated> values;
    std::vector<std::uint64_t> rounds;  ///< Of each.
    bool reached = false;               ///< Every error is as small as wanted; false where `most` rounds came first.
};

/// Sets values[i] for every i of `wanted`, independent of what other rounds gave and the same whatever else is wanted. False:
/// stop.
using DrawRound = std::function<bool(std::uint64_t round, std::span<const std::size_t> wanted, std::span<Rgb> values)>;

/// Means of `count` values, none of more than `most` rounds, until in every channel the standard error over the value is at
/// most `error` (looked at rarely: is_checked). `progress` is told in [0, 1] how much is done of what is to be expected by now.
/// None if `draw` has stopped.
[[nodiscard]] std::optional<Sampled> sample(std::size_t count, double error, std::uint64_t most, const DrawRound& draw,
                                            const std::function<void(double)>& progress);

}  // namespace aureole::app
