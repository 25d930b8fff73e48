// The sun's disk: its integral over its solid angle is the sun's illuminance.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"

#include <cmath>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;

namespace {

SkyOptions with_disk(bool disk) {
    SkyOptions options;
    options.quality = fine_single();
    options.sun_disk = disk;
    options.light = true;
    return options;
}

Sun sun_of(double zenith_rad, double radius_rad, LimbDarkening limb) {
    Sun sun = sun_at(zenith_rad, radius_rad);
    sun.limb_darkening = limb;
    return sun;
}

/// Integral of (with - without) over directions around the sun, a fifth beyond the disk's edge included.
Rgb disk_integral(Sky& with, Sky& without, const Sun& sun) {
    const glm::dvec3 across = glm::normalize(glm::cross(sun.direction, glm::dvec3(0.3, 0.9, 0.1)));
    const glm::dvec3 other = glm::cross(sun.direction, across);
    std::vector<glm::dvec3> directions;
    std::vector<double> weights;
    // A ring of squared chord c has the solid angle pi dc; from the centre outwards c = C (1 - s^2), which makes the darkening
    // of the limb, a power of s, smooth.
    const double edge = std::pow(2 * std::sin(sun.angular_radius_rad / 2), 2);
    constexpr int around = 24;
    const auto ring = [&](double chord, double solid_angle) {
        const double angle = 2 * std::asin(std::sqrt(chord) / 2);
        for (int k = 0; k < around; ++k) {
            const double turn = 2 * pi * (k + 0.5) / around;
            directions.push_back(std::cos(angle) * sun.direction +
                                 std::sin(angle) * (std::cos(turn) * across + std::sin(turn) * other));
            weights.push_back(solid_angle / around);
        }
    };
    for (const Node& s : gauss_nodes(0, 1)) ring(edge * (1 - s.at * s.at), pi * edge * 2 * s.at * s.weight);
    for (const Node& s : gauss_nodes(1.001, 1.2)) ring(edge * s.at, pi * edge * s.weight);
    const std::vector<Rgb> bright = with.radiance(directions), plain = without.radiance(directions);
    Rgb result(0);
    for (std::size_t i = 0; i < weights.size(); ++i) result += weights[i] * (bright[i] - plain[i]);
    return result;
}

void check_rgb(const Rgb& actual, const Rgb& expected, double relative) {
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(actual[c] == doctest::Approx(expected[c]).scale(1e-300).epsilon(relative));
    }
}

}  // namespace

TEST_CASE("sun disk: without air its integral over its solid angle is the illuminance, at any size") {
    Sky with(cpu_float(), presets::airless(), with_disk(true)), without(cpu_float(), presets::airless(), with_disk(false));
    for (const LimbDarkening limb : {LimbDarkening::none, LimbDarkening::neckel94})
        for (const double radius : {0.001, 0.004675, 0.05, 0.5}) {
            CAPTURE(radius);
            Sun sun = sun_of(0.6, radius, limb);
            sun.irradiance = {1, 20, 300};
            with.stand(2, sun);
            without.stand(2, sun);
            check_rgb(disk_integral(with, without, sun), sun.irradiance, 1e-3);
            check_rgb(Rgb(with.light()[9]), sun.irradiance, 1e-6);
        }
}

TEST_CASE("sun disk: darker towards the limb, the more so in blue") {
    Sky sky(cpu_float(), presets::airless(), with_disk(true));
    const Sun sun = sun_of(0.6, 0.004675, LimbDarkening::neckel94);
    sky.stand(2, sun);
    const Rgb centre = sky.radiance(sun.direction), edge = sky.radiance(direction(0.6 + 0.9 * 0.004675));
    // mu^alpha with mu = sqrt(1 - 0.81) and alpha 0.397, 0.503, 0.652.
    check_rgb(edge / centre, {0.71910, 0.65855, 0.58192}, 1e-3);
}

TEST_CASE("sun disk: through air its integral is the sun colour that hosts are given") {
    Sky with(cpu_float(), presets::earth(), with_disk(true)), without(cpu_float(), presets::earth(), with_disk(false));
    for (const double zenith : {0.0, 40.0, 80.0, 87.0}) {
        CAPTURE(zenith);
        const Sun sun = sun_of(zenith * degree, 0.004675, LimbDarkening::neckel94);
        with.stand(500, sun);
        without.stand(500, sun);
        // Light is dimmed as the disk's centre is; near the horizon its lower half loses more than its upper half gains.
        check_rgb(disk_integral(with, without, sun), Rgb(with.light()[9]), zenith > 85 ? 0.018 : 5e-3);
    }
}

TEST_CASE("sun disk: half of it is left when its centre is on the horizon, none when it has set") {
    Sky with(cpu_float(), presets::airless(), with_disk(true)), without(cpu_float(), presets::airless(), with_disk(false));
    for (const double below : {0.0, 1.1}) {
        CAPTURE(below);
        const Sun sun = sun_of(pi / 2 + below * 0.01, 0.01, LimbDarkening::none);
        with.stand(0, sun);
        without.stand(0, sun);
        const double expected = below > 0 ? 0 : 0.5;
        CHECK(std::abs(disk_integral(with, without, sun).g - expected) < 1e-3);
        CHECK(std::abs(with.light()[9].g - expected) < 1e-3);
    }
}

namespace {

SkyOptions with_lobe(double g) {
    SkyOptions options = with_disk(true);
    options.sun_lobe_g = g;
    return options;
}

/// Share of a Henyey-Greenstein lobe within the squared chord c from its middle: the integral of (1 - g^2) / (4 pi d^1.5) pi dc
/// with d = (1 - g)^2 + g c. 1 for c = 4, the whole sphere.
double share_within(double g, double c) { return (1 + g) / (2 * g) * (1 - (1 - g) / std::sqrt((1 - g) * (1 - g) + g * c)); }

}  // namespace

TEST_CASE("sun lobe: without air its integral is the sun's irradiance, as far as directions are not below the horizon") {
    for (const double g : {0.5, 0.9, 0.999, 0.9999}) {
        CAPTURE(g);
        Sky sky(cpu_float(), presets::airless(), with_lobe(g));
        Sun sun = sun_of(0, 0.004675, LimbDarkening::neckel94);
        sun.irradiance = {1, 20, 300};
        sky.stand(2, sun);
        CHECK(share_within(g, 4) == doctest::Approx(1));
        // Rings of squared chord c about the zenith; c = w (e^s - 1) spreads a peak of width w = (1 - g)^2 / g.
        const double width = (1 - g) * (1 - g) / g, edge = 1.9;
        std::vector<glm::dvec3> directions;
        std::vector<double> weights;
        for (const Node& s : gauss_nodes(0, std::log1p(edge / width))) {
            const double c = width * std::expm1(s.at);
            directions.push_back(direction(2 * std::asin(std::sqrt(c) / 2), 0.7));
            weights.push_back(pi * (c + width) * s.weight);
        }
        const std::vector<Rgb> seen = sky.radiance(directions);
        Rgb sum(0);
        for (std::size_t i = 0; i < seen.size(); ++i) sum += weights[i] * seen[i];
        check_rgb(sum, share_within(g, edge) * sun.irradiance, 2e-4);
        check_rgb(Rgb(sky.light()[9]), sun.irradiance, 1e-6);
    }
}

TEST_CASE("sun lobe: seen through the air as the disk is; a sun without a disk has none") {
    const double g = 0.99;
    Sky lobe(cpu_float(), presets::earth(), with_lobe(g)), disk(cpu_float(), presets::earth(), with_disk(true)),
        none(cpu_float(), presets::earth(), with_disk(false));
    for (const double zenith : {10.0, 80.0}) {
        const Sun sun = sun_of(zenith * degree, 0.004675, LimbDarkening::none);
        for (Sky* sky : {&lobe, &disk, &none}) sky->stand(500, sun);
        const Rgb sky = none.radiance(sun.direction);
        // Both in the middle: (1 + g) / (4 pi (1 - g)^2) against 1 / (pi C).
        const double chord = 2 * std::sin(sun.angular_radius_rad / 2);
        const double ratio = (1 + g) / (4 * (1 - g) * (1 - g)) * chord * chord;
        check_rgb(lobe.radiance(sun.direction) - sky, ratio * (disk.radiance(sun.direction) - sky), 1e-3);
        const Sun point = sun_of(zenith * degree, 0, LimbDarkening::none);
        for (Sky* sky_of : {&lobe, &none}) sky_of->stand(500, point);
        CHECK(lobe.radiance(sun.direction) == none.radiance(sun.direction));
    }
}
