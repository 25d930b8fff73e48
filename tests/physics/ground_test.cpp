// The bare ground, with and without air above it.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;

namespace {

const Rgb albedo(0.1, 0.4, 0.9);

AtmosphereParameters airless() {
    AtmosphereParameters parameters = presets::airless();
    parameters.planet.ground_albedo = albedo;
    return parameters;
}

SkyOptions of(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    return options;
}

std::vector<glm::dvec3> down_to_nadir(double dip) {
    std::vector<glm::dvec3> result;
    for (const double below : {1e-4, 0.01, 0.05, 0.2, 0.5, 1.0})
        for (const double azimuth : {0.0, 50.0, 120.0, 180.0})
            result.push_back(direction(std::min(pi / 2 + dip + below, pi), azimuth * degree));
    return result;
}

}  // namespace

TEST_CASE("airless body: the ground is albedo / pi x E x mu_s, day and night, and the sky is black") {
    const double radius = airless().planet.bottom_radius_m;
    Shell shell;
    shell.bottom = radius;
    Sky sky(cpu_float(), airless(), of(QualitySettings::standard()));
    for (const double altitude : {0.01, 2.0, 10e3, 400e3, 2e7}) {
        CAPTURE(altitude);
        const double dip = std::acos(radius / (radius + altitude));
        Worst worst;
        for (const double sun_zenith : {0.0, 50.0, 89.0, 100.0, 180.0}) {
            sky.stand(altitude, sun_at(sun_zenith * degree));
            const glm::dvec3 sun = direction(sun_zenith * degree);
            const std::vector<glm::dvec3> directions = down_to_nadir(dip);
            const std::vector<Rgb> seen = sky.radiance(directions);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                const double t = static_cast<double>(shell.to_ground(altitude, directions[i].z));
                const glm::dvec3 hit = glm::dvec3(0, 0, radius + altitude) + t * directions[i];
                const Rgb expected = albedo / pi * std::max(glm::dot(hit, sun) / radius, 0.0);
                // Relative to ground under the sun at the zenith; at the terminator the table rounds the corner.
                worst.add(sum(glm::abs(seen[i] - expected)) / sum(albedo / pi), sun_zenith, i, expected.g);
            }
            for (const double above : {1e-4, 0.1, 1.0}) CHECK(sum(sky.radiance(direction(pi / 2 + dip - above))) == 0);
        }
        CHECK_WORST(worst, altitude > 1e6 ? 2e-2 : 5e-3);
    }
}

TEST_CASE("the horizon is exact at any altitude: black a millionth above it, lit ground a millionth below it") {
    const double radius = airless().planet.bottom_radius_m;
    for (Machine* machine : {&cpu_float(), &cpu_double()}) {
        Sky sky(*machine, airless(), of(QualitySettings::standard()));
        for (const double altitude : {0.01, 2.0, 1e3, 100e3, 36e6}) {
            CAPTURE(altitude);
            sky.stand(altitude, sun_at(0));
            const double dip = std::acos(radius / (radius + altitude));
            CHECK(sum(sky.radiance(direction(pi / 2 + dip - 1e-6))) == 0);
            CHECK(sum(sky.radiance(direction(pi / 2 + dip + 1e-6))) > 0.9 * sum(albedo / pi) * std::cos(dip));
        }
    }
}

TEST_CASE("air that only absorbs: a black sky, and ground dimmed on both ways") {
    const Shell shell;
    AtmosphereParameters parameters;
    parameters.planet.ground_albedo = albedo;
    const Rgb absorption(1e-6, 3e-6, 1e-5);
    parameters.terms = {even_term(Rgb(0), absorption, RayleighPhase{})};
    Sky sky(cpu_float(), parameters, of(QualitySettings::standard()));
    for (const double altitude : {0.0, 2000.0, 50e3}) {
        CAPTURE(altitude);
        const double dip = std::acos(6360e3 / (6360e3 + altitude));
        Worst worst;
        for (const double sun_zenith : {0.0, 40.0, 75.0}) {
            sky.stand(altitude, sun_at(sun_zenith * degree));
            const glm::dvec3 sun = direction(sun_zenith * degree);
            const std::vector<glm::dvec3> directions = down_to_nadir(dip);
            const std::vector<Rgb> seen = sky.radiance(directions);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if (altitude == 0) continue;
                const double t = static_cast<double>(shell.to_ground(altitude, directions[i].z));
                const glm::dvec3 hit = glm::dvec3(0, 0, 6360e3 + altitude) + t * directions[i];
                const double mu_s = glm::dot(hit, sun) / glm::length(hit);
                const double way = t + static_cast<double>(shell.to_top(0, mu_s));
                Rgb expected;
                for (int c = 0; c < 3; ++c) expected[c] = albedo[c] / pi * std::max(mu_s, 0.0) * std::exp(-absorption[c] * way);
                worst.add(sum(glm::abs(seen[i] - expected)) / sum(albedo / pi), sun_zenith, i, expected.g);
            }
            for (const double above : {1e-4, 0.1, 1.0}) CHECK(sum(sky.radiance(direction(pi / 2 + dip - above))) < 1e-12);
        }
        if (altitude > 0) CHECK_WORST(worst, 5e-3);
    }
}

TEST_CASE("no extinction in one channel: that channel is as without air, the others as ever, and nothing is NaN") {
    AtmosphereParameters clear = presets::earth(), full = presets::earth();
    clear.terms = full.terms = {full.terms[0]};
    clear.terms[0].scattering_per_m.g = 0;
    clear.planet.ground_albedo = full.planet.ground_albedo = albedo;
    Sky without(cpu_float(), clear, of(QualitySettings::standard())), with(cpu_float(), full, of(QualitySettings::standard()));
    for (const double altitude : {0.0, 5000.0, 300e3})
        for (const double sun_zenith : {0.0, 60.0, 89.0, 93.0}) {
            CAPTURE(altitude);
            CAPTURE(sun_zenith);
            without.stand(altitude, sun_at(sun_zenith * degree));
            with.stand(altitude, sun_at(sun_zenith * degree));
            for (const double zenith : {0.0, 60.0, 89.0, 110.0, 180.0}) {
                CAPTURE(zenith);
                const Rgb seen = without.radiance(direction(zenith * degree, 0.5)),
                          other = with.radiance(direction(zenith * degree, 0.5));
                // The mean extinction of the channels places the nodes: what is left is the error of the quadrature.
                CHECK(seen.r == doctest::Approx(other.r).scale(1e-300).epsilon(2e-3));
                CHECK(seen.b == doctest::Approx(other.b).scale(1e-300).epsilon(2e-3));
                if (zenith < 90) CHECK(seen.g < 1e-12);
                if (zenith == 180 && altitude > 0)
                    CHECK(seen.g == doctest::Approx(albedo.g / pi * std::max(std::cos(sun_zenith * degree), 0.0))
                                        .scale(1e-20)
                                        .epsilon(2e-3));
            }
        }
}

TEST_CASE("a camera at altitude 0 or under the ground sees what a camera on the ground sees") {
    Sky sky(cpu_float(), presets::earth(), of(QualitySettings::standard()));
    const std::vector<glm::dvec3> directions{direction(0), direction(0.8, 1), direction(1.5), direction(1.5, 3)};
    sky.stand(0.01, sun_at(1));
    const std::vector<Rgb> expected = sky.radiance(directions);
    CHECK(sum(expected[0]) > 0.01);
    for (const double altitude : {0.0, -1.0, -10.0, -1000.0}) {
        CAPTURE(altitude);
        sky.stand(altitude, sun_at(1));
        const std::vector<Rgb> seen = sky.radiance(directions);
        for (std::size_t i = 0; i < seen.size(); ++i) CHECK(apart(seen[i], expected[i]) < 1e-3);
        // And the ground at its feet is lit.
        CHECK(sum(sky.radiance(glm::dvec3(0, 0, -1))) > 0.05);
    }
}
