// Total radiance of sky and ground against an independent Monte Carlo solution: every row of a table goes through Atmosphere,
// View and composite in float, as `aureole probe` sends it. The error of a row is sum |dL| / sum L over red, green and blue;
// rows whose standard error exceeds 2 % are left out. Run it with `-s` or look at its output for the tables of
// docs/accuracy.md.
#include "accuracy/measure.h"

#include <aureole/models/aureole.h>

#include <doctest/doctest.h>

#include <cstdio>

using namespace aureole;
using namespace aureole::physics;

namespace {

struct Limit {
    double sun_zenith_deg, median_percent, p95_percent;
};

void check(const char* file, const AtmosphereParameters& air, const QualitySettings& quality,
           std::initializer_list<Limit> limits, std::size_t least_rows = 60) {
    CAPTURE(file);
    CAPTURE(quality.name);
    auto errors = measure(file, air, models::aureole(quality));
    CHECK(errors.size() == limits.size());
    for (const Limit& limit : limits) {
        CAPTURE(limit.sun_zenith_deg);
        Errors& e = errors.at(limit.sun_zenith_deg);
        const double greatest = e.quantile(1);
        std::printf("%-10s %-15s sun %3g deg: %3zu rows, median %6.3f %%, p95 %6.2f %%, max %6.1f %%\n", file,
                    quality.name.c_str(), limit.sun_zenith_deg, e.percent.size(), e.quantile(0.5), e.quantile(0.95), greatest);
        CHECK(e.percent.size() >= least_rows);
        CHECK(e.quantile(0.5) <= limit.median_percent);
        CHECK(e.quantile(0.95) <= limit.p95_percent);
    }
}

AtmosphereParameters clear() { return presets::earth(); }

}  // namespace

TEST_CASE(
    "clear Earth, default quality: within 0.5 % (p95 1.5 %) by day, 0.7 % (4 %) at -2 degrees, 1.1 % (5.5 %) at -4 degrees") {
    check("earth.csv", clear(), QualitySettings::standard(),
          {{0, 0.3, 1.5}, {60, 0.3, 1.5}, {85, 0.5, 1.5}, {92, 0.7, 4}, {94, 1.1, 5.5}});
}

TEST_CASE("clear Earth, high quality: within 0.3 % (p95 1 %) by day, 0.5 % (2 %) at -2 degrees, 1 % (4 %) at -4 degrees") {
    check("earth.csv", clear(), QualitySettings::high(), {{0, 0.3, 1}, {60, 0.3, 1}, {85, 0.3, 1}, {92, 0.5, 2}, {94, 1, 4}});
}

// Truth here is the path tracer's, whose standard error is up to 0.5 %.
TEST_CASE("clear Earth, high quality, twilight: within 1 % (p95 4 %) at -5 and -6 degrees") {
    check("twilight.csv", clear(), QualitySettings::high(), {{95, 1, 4}, {96, 1, 4}}, 20);
}

TEST_CASE("clear Earth, default quality, twilight: no worse than measured") {
    check("twilight.csv", clear(), QualitySettings::standard(), {{95, 1.5, 6}, {96, 4, 11}}, 20);
}

// The settings below have no target of their own yet: a third more than measured, so that a change for the worse shows.
TEST_CASE("clear Earth, low quality: no worse than measured") {
    check("earth.csv", clear(), QualitySettings::low(),
          {{0, 0.81, 4.5}, {60, 1.2, 4.6}, {85, 2.1, 5.7}, {92, 3, 8.5}, {94, 3.1, 17.5}});
}

// Hillaire's own shaders on the same rays, measured by others: median 4.2 % with the sun at 0 to 75 degrees, 4.8 % at 85 to 90,
// 12 % at 94 where the 32 texels of the sun's cosine carry the planet's shadow (p90 55 %). In this range it must be, to be the
// technique that others are compared with: no worse, and no better.
TEST_CASE("clear Earth, model hillaire: as far from the truth as the published technique") {
    auto errors = measure("earth.csv", clear(), model_by_name("hillaire"), true);
    struct Range {
        double sun_zenith_deg, least_median, greatest_median, greatest_p90;
    };
    for (const Range& range : {Range{0, 2, 6, 9}, {60, 2, 6, 9}, {85, 1.2, 6, 9}, {92, 1.2, 6, 14}, {94, 6, 25, 90}}) {
        Errors& e = errors.at(range.sun_zenith_deg);
        std::printf("hillaire, sky: sun %3g deg: %3zu rows, median %6.3f %%, p90 %6.2f %%, max %6.1f %%\n",
                    range.sun_zenith_deg, e.percent.size(), e.quantile(0.5), e.quantile(0.9), e.quantile(1));
        CAPTURE(range.sun_zenith_deg);
        CHECK(e.percent.size() >= 80);
        CHECK(e.quantile(0.5) >= range.least_median);
        CHECK(e.quantile(0.5) <= range.greatest_median);
        CHECK(e.quantile(0.9) <= range.greatest_p90);
    }
}

TEST_CASE("hazy Earth and dusty Mars: no worse than measured") {
    check("hazy.csv", presets::hazy_earth(), QualitySettings::standard(), {{30, 0.85, 1.9}, {88, 2.1, 10.4}});
    check("mars.csv", presets::mars(), QualitySettings::standard(), {{60, 0.88, 2.4}, {85, 2.9, 7.2}});
}

TEST_CASE("hazy Earth and dusty Mars, high quality: within 0.5 % (p95 1.5 %) by day, 1 % (3 %) at 5 and 2 degrees") {
    check("hazy.csv", presets::hazy_earth(), QualitySettings::high(), {{30, 0.5, 1.5}, {88, 1, 3}});
    check("mars.csv", presets::mars(), QualitySettings::high(), {{60, 0.5, 1.5}, {85, 1, 3}});
}
