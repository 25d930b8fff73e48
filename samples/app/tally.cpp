#include "app/tally.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <limits>

namespace aureole::app {

void Tally::add(const Rgb& value, double count) {
    const Rgb apart = value - mean;
    mean += apart / count;
    spread += apart * (value - mean);
}

Estimated estimate(const Tally& tally, double count) {
    return {tally.mean, count > 1 ? glm::sqrt(tally.spread / (count * (count - 1))) : Rgb(0)};
}

double relative_error(const Estimated& value) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
        const double radiance = std::abs(value.radiance[c]);
        if (value.error[c] > 0)
            worst = std::max(worst, radiance > 0 ? value.error[c] / radiance : std::numeric_limits<double>::infinity());
    }
    return worst;
}

bool is_checked(std::uint64_t rounds, std::uint64_t least) {
    std::uint64_t at = least;
    while (at < rounds) at += std::max<std::uint64_t>(at / 4, 1);
    return at == rounds;
}

double expected_rounds(std::uint64_t rounds, std::uint64_t most, const Estimated& so_far, double error) {
    const double now = static_cast<double>(rounds), more = relative_error(so_far) / error;
    return std::clamp(now * more * more, now + 1, std::max(static_cast<double>(most), now + 1));
}

}  // namespace aureole::app
