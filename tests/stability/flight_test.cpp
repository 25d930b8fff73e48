// A camera that climbs from 1 cm to 10^6 km, and a sun that sets from 90 to -18 degrees, in 2000 frames each: what is shown
// flickers no more than the scene changes, and neither do float and half floats make it.
//
// CI looks at windows of neighbouring frames; AUREOLE_STABILITY_CASES=2000 takes all (tests/stability/CMakeLists.txt).
#include "stability/flight.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace aureole;
using namespace aureole::stability;

namespace {

/// How much the error of one frame differs from that of the next, of each direction and channel: what is seen to flicker.
class Flicker {
public:
    void next(const std::vector<Rgb>& seen, const std::vector<Rgb>& exact) {
        const double least = 1e-4 * brightest(exact) + 1e-10;
        std::vector<double> errors;
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (int c = 0; c < 3; ++c) errors.push_back((seen[i][c] - exact[i][c]) / std::max(exact[i][c], least));
        for (std::size_t i = 0; i < before_.size(); ++i) worst_ = std::max(worst_, std::abs(errors[i] - before_[i]));
        before_ = std::move(errors);
    }
    void cut() { before_.clear(); }
    [[nodiscard]] double worst() const { return worst_; }

private:
    std::vector<double> before_;
    double worst_ = 0;
};

/// In percent.
struct Found {
    double flicker = 0, flicker_half = 0, jump = 0;
};

Found fly(const Setting& setting, const Flight& flight) {
    const Setting plain{"single", "converged", "rgb", {}};  // rays alone: no table of the sky
    Setting in_half = setting;
    in_half.without.emplace_back("float tables");
    const bool has_half = setting.model == "aureole" || setting.model == "single-lut" || setting.model == "bruneton";
    Show run(physics::cpu_float(), setting), half(physics::cpu_float(), has_half ? in_half : setting),
        exact(physics::cpu_double(), setting), scene(physics::cpu_double(), plain);
    Flicker flicker, flicker_half;
    Jumps jumps;
    const int apart = std::max(frames * window / frames_wanted(), window);
    bool was_outside = false;
    for (int i = 0; i < frames; ++i) {
        if (i % apart >= window) continue;
        const Frame f = flight.at(i / (frames - 1.0));
        const bool is_outside = f.altitude_m > 100e3;
        // Other directions are looked in from beyond the air.
        if ((i % apart == 0 && apart > window) || is_outside != was_outside) {
            flicker.cut();
            flicker_half.cut();
            jumps.cut();
        }
        was_outside = is_outside;
        const std::vector<Rgb> seen = run.frame(f), truth = exact.frame(f);
        flicker.next(seen, truth);
        flicker_half.next(half.frame(f), truth);
        jumps.next(seen, scene.frame(f), sun_sets(f));
    }
    return {100 * flicker.worst(), 100 * flicker_half.worst(), 100 * jumps.worst()};
}

/// The most that there may be, in percent, of all flights.
struct Limits {
    const char* model;
    Found most;
};
// A third more than all 2000 frames show (docs/stability.md, which says why).
constexpr Limits limits[] = {{"fog", {0.001, 0.001, 4.8}},
                             {"single", {0.1, 0.1, 26}},
                             {"single-lut", {0.1, 0.18, 26}},
                             {"hillaire", {75, 75, 67}},
                             {"aureole", {0.09, 1.5, 5.2}}};

}  // namespace

TEST_CASE("stability, frame by frame: a flight to space and a sunset flicker no more than the scene changes") {
    for (const auto& limit : limits)
        for (const Flight& flight : flights) {
            const auto& model = limit.model;
            const auto& most = limit.most;
            INFO(model, ", ", flight.name);
            const Found found = fly({model, "low", "rgb", {}}, flight);
            if (std::getenv("AUREOLE_STABILITY_PRINT") != nullptr)
                std::printf("| %s | %s | %.4f | %.4f | %.3f |\n", model, flight.name, found.flicker, found.flicker_half,
                            found.jump);
            CHECK(found.flicker <= most.flicker);
            CHECK(found.flicker_half <= most.flicker_half);
            CHECK(found.jump <= most.jump);
        }
}
