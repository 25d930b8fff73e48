#include "measure/sampling.h"

#include <algorithm>
#include <numeric>

namespace aureole::app {
namespace {

/// How much of the rounds that are to be expected has been done.
double share(const Sampled& so_far, std::span<const std::size_t> wanted, double error, std::uint64_t most) {
    const double done = std::accumulate(so_far.rounds.begin(), so_far.rounds.end(), 0.0);
    double expected = done;
    for (const std::size_t i : wanted)
        expected += expected_rounds(so_far.rounds[i], most, so_far.values[i], error) - static_cast<double>(so_far.rounds[i]);
    return done / expected;
}

}  // namespace

std::optional<Sampled> sample(std::size_t count, double error, std::uint64_t most, const DrawRound& draw,
                              const std::function<void(double)>& progress) {
    Sampled result{std::vector<Estimated>(count), std::vector<std::uint64_t>(count), false};
    const auto settled = [&](std::size_t i) { return relative_error(result.values[i]) <= error; };
    std::vector<Tally> tallies(count);
    std::vector<Rgb> values(count);
    std::vector<std::size_t> wanted(count);
    std::iota(wanted.begin(), wanted.end(), std::size_t{0});
    for (std::uint64_t round = 1; round <= most && !wanted.empty(); ++round) {
        if (!draw(round - 1, wanted, values)) return std::nullopt;
        for (const std::size_t i : wanted) {
            tallies[i].add(values[i], static_cast<double>(round));
            result.values[i] = estimate(tallies[i], static_cast<double>(round));
            result.rounds[i] = round;
        }
        if (is_checked(round, sampling_least_rounds)) std::erase_if(wanted, settled);
        if (progress) progress(round == most ? 1 : share(result, wanted, error, most));
    }
    result.reached = std::ranges::all_of(wanted, settled);
    return result;
}

}  // namespace aureole::app
