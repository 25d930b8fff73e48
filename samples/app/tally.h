// Means of what is drawn at random in rounds, with the standard errors that they have.
#pragma once

#include <aureole/parameters.h>

#include <cstdint>

namespace aureole::app {

/// Mean of the values so far and the sum of their squared distances from it (Welford 1962).
struct Tally {
    Rgb mean{0}, spread{0};

    /// One more value, the `count`-th: the first is 1.
    void add(const Rgb& value, double count);
    [[nodiscard]] bool operator==(const Tally&) const = default;
};

/// A radiance in 1/sr, or an irradiance, per unit of solar irradiance, with its standard error.
struct Estimated {
    Rgb radiance{0}, error{0};
};
/// What `count` values say; an error of 0 of fewer than two.
[[nodiscard]] Estimated estimate(const Tally& tally, double count);
/// Largest ratio of standard error to radiance over the channels; 0 where there is no error, infinite where it is of nothing.
[[nodiscard]] double relative_error(const Estimated& value);

/// Whether the error is looked at after so many rounds, `least` or more. Stopping as soon as it looks small enough would favour
/// what is thought quiet by chance: so one looks rarely, after a quarter more each time.
[[nodiscard]] bool is_checked(std::uint64_t rounds, std::uint64_t least);
/// Rounds that it takes in all, by the error after the `rounds` so far, which are not enough: at least one more, and no more
/// than `most`.
[[nodiscard]] double expected_rounds(std::uint64_t rounds, std::uint64_t most, const Estimated& so_far, double error);

}  // namespace aureole::app
