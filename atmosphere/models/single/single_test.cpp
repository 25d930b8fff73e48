// Single scattering against closed forms, independent quadrature, and our own model where a second scattering does not matter;
// the dome against the march of each pixel; every backend.
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>

#include "common/rejects.h"
#include "passes/model_sweep.h"
#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

using namespace aureole;
using models::Dome;
using models::SingleSettings;
using models::Steps;
using physics::apart;
using physics::cpu_float;
using physics::degree;
using physics::direction;
using physics::pi;
using physics::Real;
using physics::Shell;
using physics::Sky;
using physics::sun_at;
using physics::Worst;

namespace {

const Rgb thin(1e-9, 2e-9, 4e-9);

SingleSettings midpoints(int view, int light) {
    SingleSettings settings;
    settings.steps = Steps::midpoints;
    settings.view_steps = view;
    settings.light_steps = light;
    return settings;
}
SingleSettings with_dome(const SingleSettings& base, std::uint32_t width, std::uint32_t height,
                         Dome::Phase phase = Dome::Phase::at_look_up) {
    SingleSettings settings = base;
    settings.dome.size = {width, height, 1};
    settings.dome.phase = phase;
    return settings;
}

/// Every way to scatter once.
struct Way {
    std::string name;
    ModelPtr model;
};
std::vector<Way> ways() {
    return {{"single", models::single()},
            {"single, midpoints", models::single(midpoints(128, 64))},
            {"single, dome", models::single(with_dome({}, 64, 256))},
            {"single-lut", models::single_lut()}};
}

/// Errors in percent; where the sky is dark, against a hundredth of its brightest.
std::vector<double> percents(std::span<const Rgb> seen, std::span<const Rgb> expected) {
    double brightest = 0;
    for (const Rgb& color : expected) brightest = std::max(brightest, physics::sum(color));
    std::vector<double> result;
    for (std::size_t i = 0; i < seen.size(); ++i)
        result.push_back(100 * physics::sum(glm::abs(seen[i] - expected[i])) /
                         (std::max(physics::sum(expected[i]), 1e-2 * brightest)));
    return result;
}
double quantile(std::vector<double>& values, double q) {
    std::sort(values.begin(), values.end());
    return values.at(static_cast<std::size_t>(q * static_cast<double>(values.size() - 1)));
}

AtmosphereParameters planet_with(const DensityTerm& term, const Rgb& albedo = Rgb(0)) {
    AtmosphereParameters air;
    air.planet.ground_albedo = albedo;
    air.terms = {term};
    return air;
}

physics::SkyOptions of(const ModelPtr& model) {
    physics::SkyOptions options;
    options.model = model;
    return options;
}

std::vector<glm::dvec3> directions(std::initializer_list<double> zeniths) {
    std::vector<glm::dvec3> result;
    for (const double zenith : zeniths)
        for (const double azimuth : {0.0, 35.0, 90.0, 180.0}) result.push_back(direction(zenith * degree, azimuth * degree));
    return result;
}

}  // namespace

TEST_CASE("single: thin air is E sigma p(nu) times its length") {
    const Shell shell;
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        for (const PhaseFunction& phase : {PhaseFunction{RayleighPhase{}}, PhaseFunction{HenyeyGreensteinPhase{0.9}}}) {
            Sky sky(cpu_float(), planet_with(physics::even_term(thin, Rgb(0), phase)), of(way.model));
            Worst worst;
            for (const double altitude : {0.0, 20000.0, 70000.0})
                for (const double sun_zenith : {0.0, 65.0}) {
                    sky.stand(altitude, sun_at(sun_zenith * degree));
                    std::vector<glm::dvec3> views = directions({0, 30, 60, 80, 88, 100, 150});
                    if (altitude == 0) std::erase_if(views, [](const glm::dvec3& view) { return view.z < 0; });
                    const std::vector<Rgb> seen = sky.radiance(views);
                    for (std::size_t i = 0; i < views.size(); ++i) {
                        const double nu = std::clamp(glm::dot(views[i], direction(sun_zenith * degree)), -1.0, 1.0);
                        const double length = static_cast<double>(shell.to_end(altitude, views[i].z));
                        worst.add(apart(seen[i], thin * (length * evaluate(phase, nu))), altitude, sun_zenith, views[i].x,
                                  views[i].y, views[i].z);
                    }
                }
            CHECK_WORST(worst, 3e-3);
        }
    }
}

TEST_CASE("single: after sunset the zenith shines from above the planet's shadow: E p sigma H exp(-shadow height / H)") {
    const double scale_height = 8000;
    const AtmosphereParameters air = planet_with({"air", ExponentialProfile{scale_height}, thin, Rgb(0), RayleighPhase{}});
    const double radius = air.planet.bottom_radius_m, shell = air.planet.top_radius_m - radius;
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        Sky sky(cpu_float(), air, of(way.model));
        Worst worst;
        for (const double depression : {1.0, 3.0, 5.0, 7.0}) {
            sky.stand(0, sun_at((90 + depression) * degree));
            const double shadow = radius * (1 / std::cos(depression * degree) - 1);
            const double lit = scale_height * (std::exp(-shadow / scale_height) - std::exp(-shell / scale_height));
            const Rgb expected = thin * (lit * evaluate(RayleighPhase{}, -std::sin(depression * degree)));
            worst.add(apart(sky.radiance(glm::dvec3(0, 0, 1)), expected), depression);
        }
        // Midpoints step across the shadow's edge.
        CHECK_WORST(worst, way.name == "single, midpoints" ? 0.1 : 3e-3);
    }
}

TEST_CASE("single: scattering with both losses is what quadrature says, however thick the air") {
    const double scale_height = 8000;
    const Rgb extinction(6e-6, 13e-6, 33e-6);
    const AtmosphereParameters air =
        planet_with({"air", ExponentialProfile{scale_height}, extinction * 0.9, extinction * 0.1, RayleighPhase{}});
    Shell shell;
    shell.density = [=](Real h) { return std::exp(-h / static_cast<Real>(scale_height)); };
    struct Case {
        double altitude, sun_zenith;
        std::vector<glm::dvec3> views{};
        std::vector<Rgb> expected{};
    };
    std::vector<Case> cases;
    for (const double altitude : {0.0, 10000.0})
        for (const double sun_zenith : {0.0, 60.0, 85.0}) {
            Case& wanted = cases.emplace_back(Case{altitude, sun_zenith});
            for (const double zenith : {0.0, 60.0, 85.0, 120.0})
                for (const double azimuth : {10.0, 120.0}) {
                    const glm::dvec3 view = direction(zenith * degree, azimuth * degree), sun = direction(sun_zenith * degree);
                    if (altitude == 0 && view.z < 0) continue;
                    const double radius = static_cast<double>(shell.bottom);
                    Rgb expected;
                    for (int c = 0; c < 3; ++c) {
                        const auto gathered = [&](Real t) -> Real {
                            const glm::dvec3 p = glm::dvec3(0, 0, radius + altitude) + static_cast<double>(t) * view;
                            const Real h = shell.altitude_after(altitude, view.z, t);
                            const Real mu_s = glm::dot(p, sun) / glm::length(p);
                            if (shell.hits_ground(h, mu_s)) return 0;
                            const Real columns = shell.column(altitude, view.z, 0, t) + shell.column_to_top(h, mu_s);
                            return shell.density(h) * std::exp(-columns * extinction[c]);
                        };
                        const Real length = shell.to_end(altitude, view.z);
                        expected[c] = static_cast<double>(physics::integrate(gathered, 0, length, 1e-5L)) *
                                      evaluate(RayleighPhase{}, glm::dot(view, sun)) * extinction[c] * 0.9;
                    }
                    wanted.views.push_back(view);
                    wanted.expected.push_back(expected);
                }
        }
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        Sky sky(cpu_float(), air, of(way.model));
        Worst worst;
        for (const Case& wanted : cases) {
            sky.stand(wanted.altitude, sun_at(wanted.sun_zenith * degree));
            const std::vector<Rgb> seen = sky.radiance(wanted.views);
            for (std::size_t i = 0; i < seen.size(); ++i)
                worst.add(apart(seen[i], wanted.expected[i]), wanted.altitude, wanted.sun_zenith, i);
        }
        CHECK_WORST(worst, 1e-2);
    }
}

TEST_CASE("single: without air the ground is albedo / pi E mu_s") {
    AtmosphereParameters air = presets::airless();
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        Sky sky(cpu_float(), air, of(way.model));
        sky.stand(100, sun_at(60 * degree));
        CHECK(apart(sky.radiance(glm::dvec3(0, 0, -1)), air.planet.ground_albedo * (0.5 / pi)) < 1e-4);
        CHECK(physics::sum(sky.radiance(glm::dvec3(0, 0, 1))) == 0);
    }
}

TEST_CASE(
    "single: where light is hardly scattered twice it is our own model's sky, by day and in twilight, from the ground and "
    "orbit") {
    AtmosphereParameters air = presets::earth();
    for (DensityTerm& term : air.terms) {
        term.scattering_per_m *= 1e-3;
        term.absorption_per_m *= 1e-3;
    }
    air.planet.ground_albedo = Rgb(0);
    QualitySettings fine = physics::fine_single();
    fine.sky_view = {128, 512, 1};
    Sky ours(cpu_float(), air, of(models::aureole(fine)));
    const std::vector<glm::dvec3> views = directions({0, 60, 85, 89, 103, 107, 140});
    struct Place {
        double altitude, sun_zenith;
        std::vector<Rgb> expected;
    };
    std::vector<Place> places;
    for (const double altitude : {2.0, 10000.0, 300000.0})
        for (const double sun_zenith : {0.0, 85.0, 90.0, 94.0}) {
            ours.stand(altitude, sun_at(sun_zenith * degree));
            places.push_back({altitude, sun_zenith, ours.radiance(views)});
        }
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        Sky sky(cpu_float(), air, of(way.model));
        Worst worst;
        for (const Place& place : places) {
            sky.stand(place.altitude, sun_at(place.sun_zenith * degree));
            const std::vector<double> errors = percents(sky.radiance(views), place.expected);
            for (std::size_t i = 0; i < views.size(); ++i)
                worst.add(errors[i], place.altitude, place.sun_zenith, views[i].x, views[i].y, views[i].z);
        }
        // Percent. Across the shadow's edge midpoints step and a dome interpolates.
        CHECK_WORST(worst, way.name == "single, midpoints" ? 30.0 : way.name == "single, dome" ? 10.0 : 2.0);
    }
}

TEST_CASE("single: thin air before geometry is E sigma p(nu) s, and takes next to nothing away") {
    const AtmosphereParameters air = planet_with(physics::even_term(thin, Rgb(0), RayleighPhase{}));
    const Sun sun = sun_at(50 * degree);
    for (const Way& way : ways()) {
        CAPTURE(way.name);
        physics::Picture picture(cpu_float(), air, way.model, 1e4);
        picture.place(look(air.planet.bottom_radius_m, 30000, 0, 0, 1, 4.0 / 3), {&sun, 1});
        Worst worst;
        for (const double distance : {100.0, 1e4, 1e5}) {
            const std::vector<Rgb> black = picture.render(distance, Rgb(0));
            for (std::size_t i = 0; i < black.size(); ++i) {
                const glm::dvec3 ray = picture.direction(static_cast<std::uint32_t>(i % physics::Picture::width),
                                                         static_cast<std::uint32_t>(i / physics::Picture::width));
                const double phase = evaluate(RayleighPhase{}, glm::dot(ray, glm::normalize(sun.direction)));
                worst.add(apart(black[i], thin * (distance * phase)), distance, i);
            }
            CHECK(apart(picture.render(distance, Rgb(1)).front(), Rgb(1)) < 1e-3);
        }
        CHECK_WORST(worst, 3e-3);
    }
}

TEST_CASE("single: few Gauss nodes are what many are") {
    const AtmosphereParameters air = presets::earth();
    SingleSettings fine;
    fine.view_steps = fine.light_steps = 16;
    Sky exact(cpu_float(), air, of(models::single(fine)));
    const auto worst_of = [&](const ModelPtr& model, double sun_zenith) {
        Sky sky(cpu_float(), air, of(model));
        std::vector<double> errors;
        for (const double altitude : {2.0, 2000.0, 10000.0}) {
            exact.stand(altitude, sun_at(sun_zenith * degree));
            sky.stand(altitude, sun_at(sun_zenith * degree));
            const std::vector<glm::dvec3> views = directions({0, 30, 60, 75, 85, 89});
            const std::vector<Rgb> a = sky.radiance(views), b = exact.radiance(views);
            for (const double error : percents(a, b)) errors.push_back(error);
        }
        const double median = quantile(errors, 0.5);
        return std::pair(median, quantile(errors, 0.95));
    };
    struct Row {
        const char* name;
        ModelPtr model;
        double median, p95;  // bounds, percent
    };
    const Row rows[] = {{"low, no dome", models::single([] {
                             SingleSettings low = SingleSettings::by_name("low");
                             low.dome = {};
                             return low;
                         }()),
                         3.5, 7},
                        {"low", models::single(SingleSettings::by_name("low")), 3.5, 11},
                        {"default", models::single(), 0.7, 2},
                        {"high", models::single(SingleSettings::by_name("high")), 0.35, 1},
                        {"single-lut default", models::single_lut(), 0.7, 2},
                        {"16 x 8 midpoints", models::single(midpoints(16, 8)), 4, 45},
                        {"64 x 32 midpoints", models::single(midpoints(64, 32)), 0.3, 5}};
    for (const Row& row : rows)
        for (const double sun_zenith : {0.0, 60.0, 85.0, 90.0, 94.0}) {
            const auto [median, p95] = worst_of(row.model, sun_zenith);
            std::printf("| single: %s | sun %g | median %.3f %% | p95 %.2f %% |\n", row.name, sun_zenith, median, p95);
            CAPTURE(row.name);
            CAPTURE(sun_zenith);
            CHECK(median <= row.median);
            CHECK(p95 <= row.p95);
        }
}

TEST_CASE("single: the dome's error at dawn") {
    AtmosphereParameters air = presets::earth();
    Sky pixels(cpu_float(), air, of(models::single()));
    const auto measure = [&](std::uint32_t width, std::uint32_t height, Dome::Phase phase, double elevation) {
        Sky dome(cpu_float(), air, of(models::single(with_dome({}, width, height, phase))));
        for (Sky* sky : {&pixels, &dome}) sky->stand(2, sun_at((90 - elevation) * degree));
        std::vector<glm::dvec3> views;
        for (double up = 0.25; up < 90; up *= 1.3)
            for (double azimuth = 1; azimuth < 180; azimuth += 7)
                views.push_back(direction((90 - up) * degree, azimuth * degree));
        const std::vector<Rgb> a = dome.radiance(views), b = pixels.radiance(views);
        std::vector<double> errors = percents(a, b);
        const double median = quantile(errors, 0.5), p95 = quantile(errors, 0.95), greatest = quantile(errors, 1);
        std::printf("| dome %ux%u %s | sun %g | median %.2f %% | p95 %.2f %% | max %.1f %% |\n", width, height,
                    phase == Dome::Phase::in_table ? "phase in table" : "phase at look-up", elevation, median, p95, greatest);
        return std::pair(median, p95);
    };
    for (const double elevation : {45.0, 5.0, 0.0, -4.0}) {
        CAPTURE(elevation);
        const auto coarse = measure(16, 32, Dome::Phase::at_look_up, elevation);
        const auto baked = measure(16, 32, Dome::Phase::in_table, elevation);
        const auto low = measure(24, 64, Dome::Phase::at_look_up, elevation);
        const auto fine = measure(64, 256, Dome::Phase::at_look_up, elevation);
        CHECK(coarse.second < 25);
        CHECK(low.second < 10);
        CHECK(fine.second < 2);
        CHECK(low.first < coarse.first);
        CHECK(coarse.second <= baked.second);
    }
}

TEST_CASE("single: settings out of range are named") {
    const auto rejected = [](const auto& change) {
        SingleSettings settings;
        change(settings);
        return detail::rejected_field([&] { (void)models::single(settings); });
    };
    CHECK(rejected([](SingleSettings& s) { s.steps = static_cast<Steps>(7); }) == "single.steps");
    CHECK(rejected([](SingleSettings& s) { s.view_steps = 17; }) == "single.view_steps");
    CHECK(rejected([](SingleSettings& s) { s.light_steps = 1; }) == "single.light_steps");
    CHECK(rejected([](SingleSettings& s) { s = midpoints(257, 1); }) == "single.view_steps");
    CHECK(rejected([](SingleSettings& s) { s = midpoints(256, 0); }) == "single.light_steps");
    CHECK(rejected([](SingleSettings& s) { s = midpoints(256, 1); }) == "nothing");
    CHECK(rejected([](SingleSettings& s) { s.dome.size = {3, 4, 1}; }) == "single.dome.size.width");
    CHECK(rejected([](SingleSettings& s) { s.dome.size = {4, 0, 1}; }) == "single.dome.size.height");
    CHECK(rejected([](SingleSettings& s) { s.dome.size = {4, 5, 1}; }) == "single.dome.size.height");
    CHECK(rejected([](SingleSettings& s) { s.dome.size = {4, 4, 2}; }) == "single.dome.size.depth");
    CHECK(rejected([](SingleSettings& s) { s.dome.phase = static_cast<Dome::Phase>(2); }) == "single.dome.phase");
    CHECK(rejected([](SingleSettings& s) { s.dome.format = rhi::Format::r32_float; }) == "single.dome.format");
    CHECK(rejected([](SingleSettings& s) { s.dome.size = {4, 4, 1}; }) == "nothing");
    CHECK(detail::rejected_field([] { (void)SingleSettings::by_name("ultra"); }) == "quality");
}

TEST_CASE("single: every backend shows the same, everywhere and at every hour" * doctest::test_suite("long")) {
    passes::Backends backends;
    passes::check_model(backends, models::single(), "single");
    passes::check_model(backends, models::single(SingleSettings::by_name("low")), "single, dome");
    passes::check_model(backends, models::single(with_dome(SingleSettings::by_name("low"), 10, 22, Dome::Phase::in_table)),
                        "single, dome, phase in table");
    passes::check_model(backends, models::single(midpoints(12, 5)), "single, midpoints");
}
