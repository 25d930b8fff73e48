// Where implementations are known to jump: the horizon, the top of the air, special places of the sun.
#include <doctest/doctest.h>

#include "physics/sky.h"
#include "physics/worst.h"

#include <cmath>

using namespace aureole;
using namespace aureole::physics;

namespace {

SkyOptions of(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    return options;
}

/// All that a fine table may get wrong is gone: many rows, many nodes, in double.
QualitySettings reference() {
    QualitySettings quality = QualitySettings::standard();
    quality.sky_view = {64, 1024, 1};
    quality.sky_view_nodes = 16;
    return quality;
}

double dip_of(double altitude) { return std::acos(6360e3 / (6360e3 + std::max(altitude, 0.0))); }

}  // namespace

TEST_CASE("no stripe at the horizon: across it the default tables follow fine ones in double") {
    // Seen from a man's height, the last 4 km before the horizon fill a fifth of a degree, a texel or two.
    struct Air {
        const char* preset;
        double by_day, low_sun, higher;  // of a man on the ground; from a kilometre and more
    };
    for (const Air& air : {Air{"earth", 5e-3, 3.2e-2, 6e-3}, {"hazy_earth", 3e-2, 4.6e-2, 1e-2}}) {
        CAPTURE(air.preset);
        Sky sky(cpu_float(), presets::by_name(air.preset), of(QualitySettings::standard()));
        Sky truth(cpu_double(), presets::by_name(air.preset), of(reference()));
        for (const double altitude : {0.01, 2.0, 1000.0, 10e3}) {
            for (const double sun_zenith : {60.0, 88.0}) {
                Worst worst;
                sky.stand(altitude, sun_at(sun_zenith * degree));
                truth.stand(altitude, sun_at(sun_zenith * degree));
                std::vector<glm::dvec3> fan;
                for (int i = -60; i <= 60; ++i)
                    for (const double azimuth : {5.0, 100.0})
                        fan.push_back(direction(pi / 2 + dip_of(altitude) + (i + 0.5) / 60 * degree, azimuth * degree));
                const std::vector<Rgb> seen = sky.radiance(fan), expected = truth.radiance(fan);
                for (std::size_t i = 0; i < fan.size(); ++i) worst.add(apart(seen[i], expected[i]), altitude, sun_zenith, i);
                CHECK_WORST(worst, altitude >= 1000 ? air.higher : sun_zenith < 80 ? air.by_day : air.low_sun);
            }
        }
    }
}

TEST_CASE("across the top of the air: a metre below and a metre above it show the same") {
    for (const QualitySettings& quality : {QualitySettings::standard(), QualitySettings::high()}) {
        CAPTURE(quality.name);
        Sky below(cpu_float(), presets::earth(), of(quality)), above(cpu_float(), presets::earth(), of(quality));
        Worst worst, seen;
        for (const double sun_zenith : {0.0, 60.0, 85.0, 92.0}) {
            below.stand(100e3 - 1, sun_at(sun_zenith * degree));
            above.stand(100e3 + 1, sun_at(sun_zenith * degree));
            std::vector<glm::dvec3> directions;
            for (const double under : {0.02, 0.04, 0.06, 0.09, 0.12, 0.16, 0.2, 0.3, 0.6, 1.0, pi / 2})
                for (const double azimuth : {5.0, 60.0, 130.0})
                    directions.push_back(direction(pi / 2 + under, azimuth * degree));
            const std::vector<Rgb> a = below.radiance(directions), b = above.radiance(directions);
            double brightest = 0;
            for (const Rgb& value : b) brightest = std::max(brightest, sum(value));
            for (std::size_t i = 0; i < a.size(); ++i) {
                worst.add(apart(a[i], b[i]), sun_zenith, i, sum(b[i]));
                seen.add(sum(glm::abs(a[i] - b[i])) / brightest, sun_zenith, i, sum(b[i]));
            }
        }
        // Where the limb fades into black, from a tenth to a millionth of the brightest, the rows of a table that also holds
        // the zenith are wide, and its exponential is drawn with straight lines.
        CHECK_WORST(worst, 4e-2);
        CHECK_WORST(seen, 1e-2);
    }
}

TEST_CASE("rising through the air: no step of 10 m changes the view by more than its share") {
    Sky sky(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    const std::vector<glm::dvec3> directions{direction(0.1), direction(0.9, 2), direction(1.5, 1), direction(2.5, 1)};
    Worst worst;
    std::vector<Rgb> before;
    for (int step = 0; step < 60; ++step) {
        sky.stand(20 + 10 * step, sun_at(1.3));
        const std::vector<Rgb> now = sky.radiance(directions);
        // 10 m is an eight-hundredth of the air's scale height, a hundred-and-twentieth of the aerosol's.
        for (std::size_t i = 0; i < before.size(); ++i) worst.add(apart(now[i], before[i]), step, i);
        before = now;
    }
    CHECK_WORST(worst, 1e-2);
}

TEST_CASE("from the ground to space with default settings: two metres change nothing that can be seen") {
    // The number of nodes of the sky-view pass changes at two fifths of the air. The top itself has its own test, above.
    const Planet planet = presets::earth().planet;
    const double shell = planet.top_radius_m - planet.bottom_radius_m;
    Sky below(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    Sky above(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    // Below a kilometre two metres are a share of the way to the ground.
    for (const double altitude : {1e3, 3e3, 10e3, 20e3, 30e3, 0.4 * shell - 5, 0.4 * shell, 0.4 * shell + 5, 50e3, 60e3, 80e3,
                                  95e3, shell - 5, shell + 5, 120e3, 400e3, 1000e3}) {
        std::vector<glm::dvec3> directions;
        for (const double elevation : {-60.0, -10.0, -3.0, -1.0, -0.3, 0.3, 1.0, 2.0, 4.0, 7.0, 15.0, 40.0, 80.0})
            for (const double azimuth : {5.0, 60.0, 130.0})  // elevation above the horizon
                directions.push_back(direction(pi / 2 + dip_of(altitude) - elevation * degree, azimuth * degree));
        Worst worst;
        for (const double sun_zenith : {0.0, 60.0, 85.0, 88.0, 90.0, 92.0, 94.0}) {
            below.stand(altitude - 1, sun_at(sun_zenith * degree));
            above.stand(altitude + 1, sun_at(sun_zenith * degree));
            const std::vector<Rgb> a = below.radiance(directions), b = above.radiance(directions);
            double brightest = 0;
            for (const Rgb& value : b) brightest = std::max(brightest, sum(value));
            // Relative to what is seen there, or to a hundredth of the brightest.
            for (std::size_t i = 0; i < a.size(); ++i)
                worst.add(sum(glm::abs(a[i] - b[i])) / std::max(sum(b[i]), 1e-2 * brightest), altitude, sun_zenith, i,
                          sum(b[i]));
        }
        CHECK_WORST(worst, 3e-3);
    }
}

TEST_CASE("sun at the zenith: the sky is the same all around, and next to it too") {
    Sky sky(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    for (const double altitude : {0.0, 5000.0, 300e3}) {
        const double lowest = altitude > 100e3 ? 2.2 : 1.5;
        sky.stand(altitude, sun_at(0));
        std::vector<glm::dvec3> ring;
        ring.reserve(12);
        for (int k = 0; k < 12; ++k) ring.push_back(direction(lowest, 2 * pi * k / 12 + 0.01));
        std::vector<Rgb> seen = sky.radiance(ring);
        for (const Rgb& value : seen) CHECK(apart(value, seen[0]) < 2e-5);
        const Rgb exact = seen[0];
        sky.stand(altitude, sun_at(1e-5));
        for (const Rgb& value : sky.radiance(ring)) CHECK(apart(value, exact) < 1e-3);
    }
}

TEST_CASE("sun on the horizon or at the nadir: finite, and no jump beside it") {
    Sky sky(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    const std::vector<glm::dvec3> directions{direction(0),      direction(1.5, 0), direction(1.5, 3),
                                             direction(0.8, 1), direction(2.8, 1), direction(pi / 2)};
    for (const double altitude : {0.0, 5000.0, 300e3}) {
        CAPTURE(altitude);
        for (const double sun_zenith : {pi / 2, pi / 2 + dip_of(altitude)}) {
            CAPTURE(sun_zenith);
            sky.stand(altitude, sun_at(sun_zenith - 1e-5));
            const std::vector<Rgb> before = sky.radiance(directions);
            sky.stand(altitude, sun_at(sun_zenith));
            const std::vector<Rgb> on = sky.radiance(directions);
            sky.stand(altitude, sun_at(sun_zenith + 1e-5));
            const std::vector<Rgb> after = sky.radiance(directions);
            for (std::size_t i = 0; i < on.size(); ++i) {
                CAPTURE(i);
                CHECK(sum(glm::abs(on[i] - before[i])) <= 2e-3 * sum(before[i]) + 1e-6);
                CHECK(sum(glm::abs(on[i] - after[i])) <= 2e-3 * sum(before[i]) + 1e-6);
            }
        }
        sky.stand(altitude, sun_at(pi));
        for (const Rgb& value : sky.radiance(directions)) CHECK(sum(value) < 1e-6);  // night
    }
}

TEST_CASE("dusk falls smoothly: a hundredth of a degree of sun is a small step, from day to the end of twilight") {
    Sky sky(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    const std::vector<glm::dvec3> directions{direction(0), direction(1.2, 0.5), direction(1.2, 2.5)};
    Worst worst;
    for (double sun_zenith = 85; sun_zenith < 98; sun_zenith += 0.37) {
        sky.stand(100, sun_at(sun_zenith * degree));
        const std::vector<Rgb> now = sky.radiance(directions);
        sky.stand(100, sun_at((sun_zenith + 0.01) * degree));
        const std::vector<Rgb> next = sky.radiance(directions);
        // Twilight falls by a decade in 2.5 degrees at most: a hundredth of that is 0.9 %.
        for (std::size_t i = 0; i < now.size(); ++i) {
            worst.add(apart(next[i], now[i]), sun_zenith, i);
            CHECK(sum(next[i]) < sum(now[i]) * 1.001);
        }
    }
    CHECK_WORST(worst, 2e-2);
}
