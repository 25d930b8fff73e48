// Float against double, function by function: the worst inputs, found by search, lose no more than a bound says.
#include "stability/cases.h"
#include "stability/probes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

using namespace aureole::stability;

namespace {

struct Found {
    double error = 0;
    Point at{};
};

/// Random points, then from the worst of them uphill, by steps that shrink.
Found search(Prober& prober, std::size_t probe, std::uint64_t starts) {
    std::mt19937_64 random(probe + 1);
    std::uniform_real_distribution<double> even(0, 1);
    constexpr std::size_t climbers = 8;
    std::vector<Found> best;
    for (std::uint64_t i = 0; i < starts; ++i) {
        Found found;
        for (double& u : found.at) u = even(random);
        found.error = prober.error(probe, found.at);
        best.push_back(found);
        std::ranges::sort(best, std::ranges::greater(), &Found::error);
        if (best.size() > climbers) best.pop_back();
    }
    for (Found& climber : best)
        for (std::uint64_t i = 0; i < starts / climbers; ++i) {
            const double step = std::pow(10.0, -6 * even(random));
            Found next = climber;
            for (double& u : next.at)
                if (even(random) < 0.3) u = std::clamp(u + step * (2 * even(random) - 1), 0.0, 1.0);
            next.error = prober.error(probe, next.at);
            if (next.error > climber.error) climber = next;
        }
    return *std::ranges::max_element(best, {}, &Found::error);
}

struct Kept {
    const char* name;
    Point at;
};
/// The worst that long searches have found (AUREOLE_STABILITY_PRINT shows them in this form).
constexpr Kept kept[] = {
#include "stability/worst_inputs.inc"
};

}  // namespace

TEST_CASE("stability, precision: float loses no more than stated anywhere that a search finds") {
    const bool print = std::getenv("AUREOLE_STABILITY_PRINT") != nullptr;
    const Range range = cases(1000);
    Prober prober;
    for (std::size_t i = 0; i < probes().size(); ++i) {
        const Probe& probe = probes()[i];
        INFO(std::string(probe.name));
        Found found = search(prober, i, range.end);
        for (const Kept& worst : kept)
            if (std::string_view(worst.name) == probe.name)
                found = std::max(found, Found{prober.error(i, worst.at), worst.at},
                                 [](const Found& a, const Found& b) { return a.error < b.error; });
        INFO("at ", Prober::text(found.at));
        CHECK(found.error <= probe.bound);
        if (!print) continue;
        std::printf("| %s | %s | %.3g (%g) | %.1f | %s |\n", probe.name, probe.relative_to, found.error, probe.bound,
                    std::max(std::log2(found.error), 0.0), Prober::text(found.at).c_str());
        std::printf("    {\"%s\", {", probe.name);
        for (const double u : found.at) std::printf("%.17g, ", u);
        std::printf("}},\n");
    }
}
