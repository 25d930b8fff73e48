// Nothing is lost and nothing is made: air that only scatters above ground that returns all light.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double scale_height = 8000;

/// Earth's molecules (the optical depths of red, green and blue) or an aerosol, without any absorption.
AtmosphereParameters conservative(const PhaseFunction& phase, double ground_albedo) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(ground_albedo);
    air.terms = {{"air", ExponentialProfile{scale_height}, Rgb(5.802e-6, 13.558e-6, 33.1e-6), Rgb(0), phase}};
    return air;
}

/// Cosines of the sun's zenith angle with weights for the integral over -1 .. 1, dense around the terminator.
std::vector<Node> sun_cosines() {
    std::vector<Node> result;
    for (const auto& [a, b] : {std::pair(-0.5, -0.2), {-0.2, -0.05}, {-0.05, 0.1}, {0.1, 1.0}})
        for (const Node& node : gauss_nodes(a, b)) result.push_back(node);
    return result;
}

SkyOptions options_of(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    return options;
}

const std::vector<double> view_zeniths{0, 40, 75, 88, 91, 100, 130, 180};
constexpr int azimuths = 8;

/// What the camera sees in uniform light of radiance 1 from all sides: the sum over all suns, and what comes straight through.
std::vector<Rgb> in_uniform_light(const AtmosphereParameters& air, const QualitySettings& quality, double altitude_m) {
    std::vector<glm::dvec3> directions;
    for (const double zenith : view_zeniths)
        for (int k = 0; k < azimuths; ++k) directions.push_back(direction(zenith * degree, pi * (k + 0.5) / azimuths));
    std::vector<Rgb> result(view_zeniths.size(), Rgb(0));
    Sky lit(cpu_float(), air, options_of(quality));
    for (const Node& sun : sun_cosines()) {
        lit.stand(altitude_m, sun_at(std::acos(sun.at)));
        const std::vector<Rgb> seen = lit.radiance(directions);
        for (std::size_t i = 0; i < seen.size(); ++i) result[i / azimuths] += seen[i] * (sun.weight * 2 * pi / azimuths);
    }
    SkyOptions night = options_of(quality);
    night.beyond = 1;
    Sky straight(cpu_float(), air, night);
    straight.place({0, 0, air.planet.bottom_radius_m + altitude_m}, {});
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += straight.radiance(directions[i * azimuths]);
    return result;
}

Worst furnace_error(const PhaseFunction& phase, const QualitySettings& quality, double altitude_m) {
    const std::vector<Rgb> seen = in_uniform_light(conservative(phase, 1), quality, altitude_m);
    Worst worst;
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (int c = 0; c < 3; ++c) worst.add(std::abs(seen[i][c] - 1), altitude_m, view_zeniths[i], c, seen[i][c]);
    return worst;
}

/// Irradiance of a horizontal surface from above (or, `upwards`, of its underside from below), without the sun itself.
Rgb flux(Sky& sky, double altitude_m, double sun_mu, bool upwards) {
    sky.stand(altitude_m, sun_at(std::acos(sun_mu)));
    const double horizon = -std::sqrt(1 - std::pow(6360e3 / (6360e3 + altitude_m), 2));
    std::vector<glm::dvec3> directions;
    std::vector<double> weights;
    // On each side of the horizon, so that no node straddles it.
    const auto band = [&](double a, double b) {
        for (const Node& mu : gauss_nodes(a, b))
            for (int k = 0; k < azimuths; ++k) {
                directions.push_back(direction(std::acos(mu.at), pi * (k + 0.5) / azimuths));
                weights.push_back(mu.weight * std::abs(mu.at) * 2 * pi / azimuths);
            }
    };
    if (upwards) {
        band(-1, horizon);
        if (horizon < 0) band(horizon, 0);
    } else {
        band(0, 0.2);
        band(0.2, 1);
    }
    const std::vector<Rgb> seen = sky.radiance(directions);
    Rgb result(0);
    for (std::size_t i = 0; i < seen.size(); ++i) result += seen[i] * weights[i];
    return result;
}

}  // namespace

TEST_CASE("white furnace: in uniform light a white planet and its air cannot be seen") {
    QualitySettings high = QualitySettings::high();
    high.sky_view = QualitySettings::standard().sky_view;  // its size is no part of this
    for (const double altitude : {0.0, 8000.0, 99e3})
        CHECK_WORST(furnace_error(RayleighPhase{}, QualitySettings::standard(), altitude), 2.5e-2);
    for (const double altitude : {0.0, 99e3}) CHECK_WORST(furnace_error(RayleighPhase{}, high, altitude), 1e-2);
    CHECK_WORST(furnace_error(HenyeyGreensteinPhase{0.5}, high, 500), 1.2e-2);
    CHECK_WORST(furnace_error(HenyeyGreensteinPhase{-0.5}, high, 500), 2e-2);
}

TEST_CASE("energy: what the sun sends in comes out again or is absorbed by the ground") {
    const double bottom = 6360e3, top = 6460e3;
    // All powers per 2 pi top^2, what the integral over the sun's cosine leaves of the sphere. The cross-section is pi top^2.
    Shell shell;
    shell.density = [](Real h) { return std::exp(-h / static_cast<Real>(scale_height)); };
    for (const double albedo : {1.0, 0.0}) {
        CAPTURE(albedo);
        const AtmosphereParameters air = conservative(RayleighPhase{}, albedo);
        SkyOptions options = options_of(QualitySettings::standard());
        options.light = true;
        Sky sky(cpu_float(), air, options);
        Rgb out(0), absorbed(0), straight(0);
        for (const Node& sun : sun_cosines()) {
            out += flux(sky, top - bottom, sun.at, true) * sun.weight;
            Rgb down = flux(sky, 0, sun.at, false);
            if (sun.at > 0) down += Rgb(sky.light()[9]) * sun.at;
            absorbed += down * ((1 - albedo) * sun.weight * bottom * bottom / (top * top));
        }
        // Sunlight that passes the planet through its air: rings of radius b around the axis, over the cross-section.
        for (int c = 0; c < 3; ++c)
            straight[c] = static_cast<double>(integrate(
                [&](Real b) {
                    const Real mu = -std::sqrt(1 - b * b / (shell.top * shell.top));
                    return b / (shell.top * shell.top) *
                           std::exp(-shell.column(shell.top - shell.bottom, mu, 0, -2 * shell.top * mu) *
                                    air.terms[0].scattering_per_m[c]);
                },
                shell.bottom, shell.top, 1e-4L));
        for (int c = 0; c < 3; ++c) {
            CAPTURE(out[c]);
            CAPTURE(absorbed[c]);
            CAPTURE(straight[c]);
            CHECK(out[c] + absorbed[c] + straight[c] == doctest::Approx(0.5).scale(1e-300).epsilon(0.012));
        }
    }
}

TEST_CASE("thick air that absorbs nothing gives back no more than it gets, and the share of it that is stated") {
    // Above black ground, up and down together are what the sun sends in, on each square metre. The planet is curved, and so
    // is the share of a slant sun that passes between the levels: a percent or two.
    struct Case {
        double depth, least_low, least_default;
    };
    // What is lost grows with the number of scatterings: multi_scatter.md has these figures.
    std::printf("share of the light that air without absorption gives back\n");
    for (const QualitySettings& quality : {QualitySettings::low(), QualitySettings::standard()})
        for (const Case& wanted :
             {Case{0.3, 0.98, 0.98}, {1, 0.94, 0.96}, {2, 0.87, 0.94}, {5, 0.6, 0.84}, {20, 0.27, 0.44}, {100, 0.18, 0.3}})
            for (const double g : {0.0, 0.6}) {
                CAPTURE(quality.name);
                CAPTURE(wanted.depth);
                CAPTURE(g);
                AtmosphereParameters air = conservative(HenyeyGreensteinPhase{g}, 0);
                air.terms[0].scattering_per_m = Rgb(wanted.depth / scale_height);
                SkyOptions options = options_of(quality);
                options.light = true;
                Sky sky(cpu_float(), air, options);
                const double sun_mu = 0.9;
                const Rgb out = flux(sky, 100e3, sun_mu, true);
                Rgb down = flux(sky, 0, sun_mu, false);
                down += Rgb(sky.light()[9]) * sun_mu;
                const double share = (out.g * std::pow(6460.0 / 6360.0, 2) + down.g) / sun_mu;
                std::printf("| %s | %g | %g | %.2f |\n", quality.name.c_str(), wanted.depth, g, share);
                CHECK(share < 1.02);
                CHECK(share > (quality.name == "default" ? wanted.least_default : wanted.least_low));
            }
}
