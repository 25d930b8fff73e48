// Ratio tracking, which has no bias, against quadrature, path by path: what the quadrature's bias is at most, over all orders.
#include <doctest/doctest.h>

#include "models/reference/small_planet.h"
#include "physics/traced.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace aureole;
using namespace aureole::physics;
using models::ReferenceSettings;

namespace {

constexpr int batches = 32;  // of paths, by whose means errors are known

struct Scene {
    std::string name;
    AtmosphereParameters air;
    double altitude_m;
    std::vector<double> sun_zeniths_deg, view_zeniths_deg;
};
std::vector<Scene> scenes() {
    return {{"Earth, day", presets::earth(), 200, {30, 60}, {20, 80, 120}},
            {"Earth, sunset, level", presets::earth(), 200, {88, 91}, {85, 89.5, 90.1}},
            {"haze", presets::hazy_earth(), 200, {40, 85}, {20, 85, 95}},
            {"U.S. standard (tables)", presets::us_standard_1976(), 200, {40, 88}, {20, 88, 100}},
            {"Titan", presets::titan(), 20e3, {30, 80}, {30, 80, 120}},
            {"small planet", small_planet(), 1e3, {40, 92}, {20, 88, 140}}};
}

struct Mean {
    std::vector<std::vector<Rgb>> batch;  ///< By frame and direction.
    double seconds = 0;
};
Mean look(const AtmosphereParameters& air, const ReferenceSettings& settings, const Scene& scene,
          const std::vector<glm::dvec3>& directions) {
    Mean result;
    Sky sky(cpu_double(), air, traced(settings));
    const auto begin = std::chrono::steady_clock::now();
    for (int frame = 0; frame < batches; ++frame) {
        sky.air().set_frame(static_cast<std::uint64_t>(frame));
        std::vector<Rgb>& seen = result.batch.emplace_back();
        for (const double sun : scene.sun_zeniths_deg) {
            sky.stand(scene.altitude_m, sun_at(sun * degree));
            for (const Rgb& value : sky.radiance(directions)) seen.push_back(value);
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

/// Of a value of each batch: mean, and variance of the mean.
struct Moments {
    double mean = 0, variance = 0;
};
template <class F>
Moments moments(const F& of_batch) {
    double sum = 0, squares = 0;
    for (int i = 0; i < batches; ++i) sum += of_batch(i), squares += of_batch(i) * of_batch(i);
    const double mean = sum / batches;
    return {mean, (squares / batches - mean * mean) / (batches - 1.0)};
}

/// Variance of single values of one over that of the other, on average.
double variance_ratio(const Mean& one, const Mean& other) {
    double sum = 0;
    const std::size_t values = one.batch[0].size();
    for (std::size_t i = 0; i < values; ++i)
        for (int c = 0; c < 3; ++c) {
            const auto variance = [&](const Mean& of) {
                return moments([&](int k) { return of.batch[static_cast<std::size_t>(k)][i][c]; }).variance;
            };
            sum += variance(one) / std::max(variance(other), 1e-30);
        }
    return sum / static_cast<double>(3 * values);
}

/// Quadrature less ratio tracking in so many paths a direction and batch, relative to the radiance, as a mean over suns and
/// directions: nothing but noise, of which a scene's mean has at most `most_error`. If `costs`, also what ratio tracking costs
/// against what is the default, whose first order is by nodes.
void compare_trackings(int count, double most_error, bool costs) {
    double squares = 0;
    int means = 0, seed = 0;
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.name);
        ReferenceSettings nodes = paths(count, ++seed), sampled = nodes, ratio = nodes;
        sampled.sampled_first_order = true;
        ratio.tracking = ReferenceSettings::Tracking::ratio;
        std::vector<glm::dvec3> directions;
        for (const double zenith : scene.view_zeniths_deg)
            for (const double azimuth : {20.0, 130.0}) directions.push_back(direction(zenith * degree, azimuth * degree));
        const Mean a = look(scene.air, sampled, scene, directions), b = look(scene.air, ratio, scene, directions);
        const std::size_t values = b.batch[0].size();
        std::printf("%-24s", scene.name.c_str());
        for (int c = 0; c < 3; ++c) {
            const auto value = [&](const Mean& of, int k, std::size_t i) {
                return of.batch[static_cast<std::size_t>(k)][i][c];
            };
            std::vector<double> radiance(values);
            for (std::size_t i = 0; i < values; ++i) radiance[i] = moments([&](int k) { return value(b, k, i); }).mean;
            const Moments apart = moments([&](int k) {
                double sum = 0;
                for (std::size_t i = 0; i < values; ++i) sum += (value(a, k, i) - value(b, k, i)) / radiance[i];
                return sum / static_cast<double>(values);
            });
            const double error = std::sqrt(apart.variance);
            std::printf("  %+.3f +- %.3f %%", 100 * apart.mean, 100 * error);
            CHECK(std::abs(apart.mean) < 4 * error);
            CHECK(error < most_error);
            squares += apart.mean * apart.mean / apart.variance;
            ++means;
        }
        if (costs) {
            const Mean plain = look(scene.air, nodes, scene, directions);
            std::printf("; %.2f times the variance in %.2f of the time", variance_ratio(b, plain), b.seconds / plain.seconds);
        }
        std::printf("\n");
    }
    const double rms = std::sqrt(squares / means);
    std::printf("rms of %d means: %.2f standard errors\n", means, rms);
    CHECK(rms < 1.6);  // of 18 values, a third of them independent: one in a hundred is more
}

}  // namespace

TEST_CASE("reference: ratio tracking and quadrature agree, path by path") { compare_trackings(24, 0.01, false); }

// Minutes: reference.md has the command and the figures.
TEST_CASE("reference: ratio tracking and quadrature agree, in many paths" * doctest::skip()) {
    compare_trackings(512, 6e-3, true);  // Titan's blue; half a thousandth elsewhere
}
