// Total radiance of sky and ground against an independent Monte Carlo solution: every row of a table goes through Atmosphere,
// View and composite in float, as `aureole probe` sends it. The error of a row is sum |dL| / sum L over red, green and blue;
// rows whose standard error exceeds 2 % are left out. Run it with `-s` or look at its output for the tables of
// docs/accuracy.md.
#include "physics/sky.h"
#include "physics/truth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr const char* channels[] = {"r_per_sr", "g_per_sr", "b_per_sr"};

struct Errors {
    std::vector<double> percent;
    [[nodiscard]] double quantile(double q) {
        std::sort(percent.begin(), percent.end());
        return percent.at(std::min(percent.size() - 1, static_cast<std::size_t>(q * static_cast<double>(percent.size()))));
    }
};

/// Errors by zenith angle of the sun, in degrees.
std::map<double, Errors> measure(const char* file, const AtmosphereParameters& air, const QualitySettings& quality) {
    const TruthTable table = read_truth(file);
    std::map<std::pair<double, double>, std::vector<std::map<std::string, std::string>>> groups;
    for (const auto& row : table.rows) groups[{number(row, "sun_zenith_deg"), number(row, "altitude_km")}].push_back(row);

    SkyOptions options;
    options.quality = quality;
    Sky sky(cpu_float(), air, options);
    std::map<double, Errors> errors;
    for (const auto& [place, rows] : groups) {
        sky.stand(place.second * 1000, sun_at(place.first * degree));
        std::vector<glm::dvec3> directions;
        for (const auto& row : rows)
            directions.push_back(direction(number(row, "view_zenith_deg") * degree, number(row, "azimuth_deg") * degree));
        const std::vector<Rgb> seen = sky.radiance(directions);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Rgb truth;
            bool certain = true;
            for (int c = 0; c < 3; ++c) {
                truth[c] = number(rows[i], std::string("L_") + channels[c]);
                certain &= number(rows[i], std::string("stderr_") + channels[c]) <= 0.02 * truth[c];
            }
            if (certain && sum(truth) > 0) errors[place.first].percent.push_back(100 * apart(seen[i], truth));
        }
    }
    return errors;
}

struct Limit {
    double sun_zenith_deg, median_percent, p95_percent;
};

void check(const char* file, const AtmosphereParameters& air, const QualitySettings& quality,
           std::initializer_list<Limit> limits) {
    CAPTURE(file);
    CAPTURE(quality.name);
    auto errors = measure(file, air, quality);
    CHECK(errors.size() == limits.size());
    for (const Limit& limit : limits) {
        CAPTURE(limit.sun_zenith_deg);
        Errors& e = errors.at(limit.sun_zenith_deg);
        const double greatest = e.quantile(1);
        std::printf("%-10s %-15s sun %3g deg: %3zu rows, median %6.3f %%, p95 %6.2f %%, max %6.1f %%\n", file,
                    quality.name.c_str(), limit.sun_zenith_deg, e.percent.size(), e.quantile(0.5), e.quantile(0.95), greatest);
        CHECK(e.percent.size() >= 60);
        CHECK(e.quantile(0.5) <= limit.median_percent);
        CHECK(e.quantile(0.95) <= limit.p95_percent);
    }
}

AtmosphereParameters clear() { return presets::earth(); }

}  // namespace

TEST_CASE("clear Earth, default quality: within 0.7 % (p95 2 %) by day, 1 % (4 %) at -2 degrees, 2 % (8 %) at -4 degrees") {
    check("earth.csv", clear(), QualitySettings::standard(), {{0, 0.7, 2}, {60, 0.7, 2}, {85, 0.7, 2}, {92, 1, 4}, {94, 2, 8}});
}

TEST_CASE("clear Earth, high quality: within 0.3 % (p95 1.2 %) by day, 0.5 % (2 %) at -2 degrees, 1 % (4 %) at -4 degrees") {
    check("earth.csv", clear(), QualitySettings::high(),
          {{0, 0.3, 1.2}, {60, 0.3, 1.2}, {85, 0.3, 1.2}, {92, 0.5, 2}, {94, 1, 4}});
}

// The settings below have no target of their own yet: a third more than measured, so that a change for the worse shows.
TEST_CASE("clear Earth, low quality: no worse than measured") {
    check("earth.csv", clear(), QualitySettings::low(),
          {{0, 1.6, 5.8}, {60, 2, 6.2}, {85, 2.8, 6}, {92, 5.7, 14}, {94, 12, 31}});
}

TEST_CASE("clear Earth, the published 2020 sampling: far from the truth where it was measured to be") {
    check("earth.csv", clear(), QualitySettings::published_2020(),
          {{0, 10, 26}, {60, 13, 26}, {85, 11, 61}, {92, 6.5, 130}, {94, 12, 130}});
}

TEST_CASE("hazy Earth and dusty Mars: no worse than measured") {
    check("hazy.csv", presets::hazy_earth(), QualitySettings::standard(), {{30, 1.7, 9.5}, {88, 4.6, 11.5}});
    check("mars.csv", presets::mars(), QualitySettings::standard(), {{60, 2.2, 7.5}, {85, 5.8, 13.5}});
}

TEST_CASE("hazy Earth and dusty Mars, high quality: within 0.5 % (p95 1.5 %) by day, 1 % (3 %) at 5 and 2 degrees") {
    check("hazy.csv", presets::hazy_earth(), QualitySettings::high(), {{30, 0.5, 1.5}, {88, 1, 3}});
    check("mars.csv", presets::mars(), QualitySettings::high(), {{60, 0.5, 1.5}, {85, 1, 3}});
}
