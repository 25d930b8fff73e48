#include "plan/predict.h"

#include "plan/candidates.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>

using namespace aureole;
using namespace aureole::detail;

namespace {

/// What ships, and as many scenes again as make `scenes`: each somewhere around one that there is.
MeasuredSkies with_scenes(std::size_t scenes) {
    MeasuredSkies skies = measured_in_rgb();
    std::uint32_t state = 1;
    const auto random = [&] {
        state = state * 1664525U + 1013904223U;
        return (state >> 8) / 16777216.0;
    };
    const std::size_t known = skies.scenes.size();
    for (std::size_t i = known; i < scenes; ++i) {
        MeasuredScene scene = skies.scenes[i % known];
        scene.id += " " + std::to_string(i);
        for (double& coordinate : scene.situation) coordinate += random() - 0.5;
        skies.scenes.push_back(scene);
        for (MeasuredSetting& setting : skies.settings)
            for (const auto error : measured_errors) (setting.*error).by_scene.push_back((setting.*error).by_scene[i % known]);
    }
    return skies;
}

PlanRequirements everywhere() {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {-90, 90};
    needs.altitude_m = {0, 1e8};
    needs.geometry = true;
    needs.tolerance = 0.02;
    return needs;
}

template <class Work>
double milliseconds_of(const Work& work) {
    const std::clock_t start = std::clock();  // of this program alone: a busy machine does not count
    work();
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("predict: a measured scene is found again, from all scenes or from some of them") {
    const MeasuredSkies& skies = measured_in_rgb();
    std::vector<std::size_t> even;
    for (std::size_t i = 0; i < skies.scenes.size(); i += 2) even.push_back(i);
    const Predictor all(skies), half(skies, even);
    for (const std::size_t scene : even)
        for (const Predictor* predictor : {&all, &half}) {
            Predictor::Here here = predictor->at(skies.scenes[scene].situation);
            CHECK(here.distance() < 0.01);
            CHECK(here.nearest(1).at(0) == scene);
            for (const MeasuredSetting& setting : skies.settings) {
                if (setting.sky_p95.by_scene[scene] == MeasuredError::unknown) continue;
                const auto found = here.predict(setting.sky_p95);
                if (!found) continue;  // known in too few of the half
                CHECK(1000 * std::log(found->likely) ==
                      doctest::Approx(setting.sky_p95.by_scene[scene]).epsilon(1e-3).scale(1));
                CHECK(found->bound / found->likely < 1.01);
            }
        }
    CHECK(half.at(skies.scenes[1].situation).distance() > 0.01);
    CHECK(half.at(skies.scenes[1].situation).nearest(100).size() == even.size());
}

TEST_CASE("predict: a range's bound covers every measured scene inside it, and every narrower range") {
    const Predictor predictor(measured_in_rgb());
    const MeasuredSkies& skies = predictor.skies();
    const auto air = static_cast<std::size_t>(std::ranges::find(skies.airs, "earth") - skies.airs.begin());
    const auto bounds = [&](PlanRange suns, PlanRange altitudes) {
        PlanRequirements needs = everywhere();
        needs.geometry = false;
        needs.sun_elevation_deg = suns;
        needs.altitude_m = altitudes;
        return outlook(needs, predictor, situations_of(needs, skies)).candidates;
    };
    const auto whole = bounds({-10, 80}, {1, 9e5});
    std::size_t inside = 0;
    for (std::size_t scene = 0; scene < skies.scenes.size(); ++scene) {
        const MeasuredScene& at = skies.scenes[scene];
        if (at.air != air || at.sun_elevation_deg < -10 || at.sun_elevation_deg > 80 || at.altitude_m > 9e5) continue;
        ++inside;
        const auto here = bounds({at.sun_elevation_deg, at.sun_elevation_deg}, {at.altitude_m, at.altitude_m});
        for (std::size_t i = 0; i < here.size(); ++i) {
            INFO(at.id, ": ", here[i].setting.id());
            CHECK(whole[i].error.bound >= here[i].error.bound);
            const MeasuredError& error = skies.settings[i].sky_p95;
            if (error.by_scene[scene] != MeasuredError::unknown)  // kept in thousandths of its logarithm
                CHECK(whole[i].error.bound >= 0.998 * std::exp(error.by_scene[scene] / 1000.0));
        }
    }
    CHECK(inside > 10);
}

TEST_CASE("predict: several threads that ask at once are told what one is") {
    const Predictor predictor(measured_in_rgb());
    const PlanRequirements needs = everywhere();
    const std::vector<Situation> places = situations_of(needs, predictor.skies());
    const auto bounds = [&] {
        std::vector<double> result;
        for (const PlanCandidate& one : outlook(needs, predictor, places).candidates) result.push_back(one.error.bound);
        return result;
    };
    const std::vector<double> alone = bounds();
    std::vector<std::vector<double>> together(4);
    std::vector<std::thread> threads;
    threads.reserve(together.size());
    for (std::vector<double>& result : together) threads.emplace_back([&] { result = bounds(); });
    for (std::thread& thread : threads) thread.join();
    for (const std::vector<double>& result : together) CHECK(result == alone);
}

TEST_CASE("predict: what light errs by counts where it is needed, and a table without it says nothing of it") {
    MeasuredSkies skies = measured_in_rgb();
    const std::size_t scenes = skies.scenes.size();
    for (MeasuredSetting& setting : skies.settings) setting.light = {0, std::vector(scenes, MeasuredError::unknown)};
    PlanRequirements needs = everywhere();
    const std::vector<Situation> places = situations_of(needs, skies);
    const auto seen = [&](bool light) {
        needs.light = light;
        return outlook(needs, Predictor(skies), places).candidates;
    };
    const std::vector<PlanCandidate> before = seen(false), unknown = seen(true);
    skies.settings[0].light = {0.1, std::vector(scenes, MeasuredError::pack(30.0))};
    skies.settings[1].light = {0.1, std::vector(scenes, MeasuredError::pack(1e-5))};
    const std::vector<PlanCandidate> with = seen(true), without = seen(false);
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(unknown[i].error.bound == before[i].error.bound);
        CHECK(without[i].error.bound == before[i].error.bound);
    }
    CHECK(with[0].error.light == doctest::Approx(30).epsilon(1e-3).scale(1e-300));
    CHECK(with[0].error.bound > std::max(30.0, before[0].error.p95));
    CHECK(with[0].error.p95 == before[0].error.p95);
    CHECK(with[1].error.light == doctest::Approx(1e-5).epsilon(1e-2).scale(1e-300));
    CHECK(with[1].error.bound == before[1].error.bound);
    CHECK(with[2].excluded == "was not measured");
    CHECK(without[2].excluded.empty());
}

// How plan.md's figures are made: atmosphere_inputs_test -tc='predict: how long*' --no-skip
TEST_CASE("predict: how long it takes" * doctest::skip()) {
    for (const std::size_t scenes : {measured_in_rgb().scenes.size(), std::size_t{200}}) {
        const MeasuredSkies skies = with_scenes(scenes);
        std::optional<Predictor> predictor;
        const double once = milliseconds_of([&] { predictor.emplace(skies); });
        PlanRequirements needs = everywhere();
        const std::vector<Situation> places = situations_of(needs, skies);
        const double widest = milliseconds_of([&] { (void)outlook(needs, *predictor, places); });
        const double one = milliseconds_of([&] { (void)outlook(needs, *predictor, {places.front()}); });
        MESSAGE(scenes, " scenes: ", once, " ms once; ", widest, " ms in ", places.size(), " places, ", one, " ms in one");
    }
}
