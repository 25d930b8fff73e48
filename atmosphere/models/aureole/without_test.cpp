// What can be left out: scattering again, and the ground's light on the air. What stays is held to what has no such light by
// itself: single scattering marched for each pixel, black ground, air that hardly scatters twice.
#include <aureole/models/aureole.h>
#include <aureole/models/single.h>
#include <aureole/models/spectral.h>

#include "passes/model_sweep.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::passes;
using physics::degree;
using physics::direction;
using physics::Sky;

namespace {

QualitySettings single_alone(QualitySettings quality) {
    quality.multi_scatter_orders = 0;
    return quality;
}
QualitySettings without_ground_light(QualitySettings quality) {
    quality.ground_light = false;
    return quality;
}

AtmosphereParameters with_albedo(AtmosphereParameters air, double albedo) {
    air.planet.ground_albedo = Rgb(albedo);
    return air;
}

physics::SkyOptions of(const ModelPtr& model) {
    physics::SkyOptions options;
    options.model = model;
    return options;
}

/// All over the sky and the ground, the sun's aureole and the horizon's two sides among them.
std::vector<glm::dvec3> views() {
    std::vector<glm::dvec3> result;
    for (const double zenith : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0, 89.5, 95.0, 100.0, 120.0, 150.0, 180.0})
        for (const double azimuth : {0.0, 10.0, 50.0, 90.0, 135.0, 180.0})
            result.push_back(direction(zenith * degree, azimuth * degree));
    return result;
}

/// Errors in percent, sorted. Where it is dark, against a hundredth of the brightest.
std::vector<double> percents(Sky& sky, Sky& expected, double altitude, double elevation) {
    for (Sky* each : {&sky, &expected}) each->stand(altitude, physics::sun_at((90 - elevation) * degree));
    const std::vector<Rgb> a = sky.radiance(views()), b = expected.radiance(views());
    double brightest = 0;
    for (const Rgb& color : b) brightest = std::max(brightest, physics::sum(color));
    CHECK(brightest > 0);
    std::vector<double> result;
    for (std::size_t i = 0; i < a.size(); ++i)
        result.push_back(100 * physics::sum(glm::abs(a[i] - b[i])) / std::max(physics::sum(b[i]), 1e-2 * brightest));
    std::sort(result.begin(), result.end());
    return result;
}

/// Tables against the nested march of each pixel: the greatest median and error of any place and hour, percent.
void check_single(const char* what, const AtmosphereParameters& air, const ModelPtr& tables, const ModelPtr& marched,
                  double median, double greatest) {
    Sky ours(physics::cpu_double(), air, of(tables)), expected(physics::cpu_double(), air, of(marched));
    for (const double altitude : {2.0, 10e3, 300e3})
        for (const double elevation : {60.0, 5.0, 0.0, -4.0}) {
            const std::vector<double> errors = percents(ours, expected, altitude, elevation);
            std::printf("| single scattering alone | %s | %g m | sun %g | median %.3f %% | max %.2f %% |\n", what, altitude,
                        elevation, errors[errors.size() / 2], errors.back());
            CAPTURE(what);
            CAPTURE(altitude);
            CAPTURE(elevation);
            CHECK(errors[errors.size() / 2] <= median);
            CHECK(errors.back() <= greatest);
        }
}

/// Nodes as many as there can be on both sides: what is left is what tables interpolate.
ModelPtr exact_march() {
    models::SingleSettings settings;
    settings.view_steps = settings.light_steps = 16;
    return models::single(settings);
}
QualitySettings tables_of(rhi::Extent transmittance, rhi::Extent sky_view) {
    QualitySettings quality = single_alone(QualitySettings::high());
    quality.transmittance = transmittance;
    quality.sky_view = sky_view;
    quality.transmittance_nodes = quality.sky_view_nodes = 16;
    return quality;
}

}  // namespace

TEST_CASE("aureole without multiple scattering: single scattering marched for each pixel, but for what tables interpolate") {
    for (const char* preset : {"earth", "mars"}) {
        const AtmosphereParameters air = presets::by_name(preset);
        const auto name = [&](const char* size) { return std::string(preset) + ", " + size; };
        check_single(name("coarse").c_str(), air, models::aureole(tables_of({64, 16, 1}, {24, 64, 1})), exact_march(), 0.6, 8);
        check_single(name("fine").c_str(), air, models::aureole(tables_of({256, 64, 1}, {64, 256, 1})), exact_march(), 0.04,
                     0.6);
    }
}

TEST_CASE("aureole without multiple scattering: the air before geometry is single scattering's, but for the slabs of froxels") {
    QualitySettings quality = single_alone(QualitySettings::high());
    quality.aerial_perspective = {16, 64, 128};
    quality.aerial_perspective_nodes = 4;
    for (const char* preset : {"earth", "mars"}) {
        const AtmosphereParameters air = presets::by_name(preset);
        physics::Picture ours(physics::cpu_double(), air, quality, 1e5),
            expected(physics::cpu_double(), air, exact_march(), 1e5);
        for (const double elevation : {60.0, 5.0}) {
            const Sun sun = physics::sun_at((90 - elevation) * degree);
            for (physics::Picture* each : {&ours, &expected})
                each->place(look(air.planet.bottom_radius_m, 2000, 0, 0.1, 0.7, 4.0 / 3), {&sun, 1});
            for (const double distance : {3e3, 8e4}) {
                const std::vector<Rgb> a = ours.render(distance, Rgb(0)), b = expected.render(distance, Rgb(0));
                physics::Worst worst;
                for (std::size_t i = 0; i < a.size(); ++i) worst.add(physics::apart(a[i], b[i]), elevation, distance, i);
                CAPTURE(preset);
                CHECK_WORST(worst, 0.02);
            }
        }
    }
}

TEST_CASE("aureole without multiple scattering, in N wavelengths: single scattering in N wavelengths") {
    const models::SpectralSettings four{.wavelengths = spectrum::fitted(4)};
    const QualitySettings quality = tables_of({256, 64, 1}, {64, 256, 1});
    check_single("earth, 4 wavelengths", presets::earth(), models::spectral(models::aureole(quality), four),
                 models::spectral(exact_march(), four), 0.04, 0.6);
}

TEST_CASE("aureole without multiple scattering: there is no table, no pass and no memory of it, whatever changes") {
    Backends backends;
    backends.each([](Backend& backend) {
        CAPTURE(backend.name());
        Setup setup;
        const std::uint64_t all = AirRig(backend, setup).air.table_bytes();
        setup.quality = single_alone(small_quality());
        Rig rig(backend, setup);
        rig.air.set_multi_scatter_passes_per_frame(1);
        CHECK(!rig.air.multi_scatter_table());
        CHECK(rig.air.table_bytes() < all);
        REQUIRE(rig.air.reports().size() == 1);
        CHECK(rig.air.reports()[0].name == "transmittance");
        const Camera camera = camera_at(setup.air.planet, 200);
        Image before;
        for (const AtmosphereParameters& air :
             {setup.air, with_albedo(setup.air, 0.9), presets::mars(), presets::airless(), setup.air}) {
            rig.air.set_parameters(air);
            CHECK(rig.record_air().dispatches == 1);
            CHECK(rig.air.reports()[0].recorded);
            CHECK(rig.record_air().total() == 0);
            rig.record_view(camera, sun_at(10));
            CHECK(rig.sky_view() != before);
            before = rig.sky_view();
        }
        rig.air.invalidate();
        CHECK(rig.record_air().dispatches == 1);
        rig.record_view(camera, sun_at(10));
        CHECK(rig.sky_view() == before);
    });
}

TEST_CASE("aureole without multiple scattering: a device need not hold its table") {
    const auto cpu = open_cpu_float();
    QualitySettings quality = small_quality();
    quality.multi_scatter = {10, 256, 1};
    quality.angular_order = 8;
    rhi::Capabilities little = cpu->device().capabilities();
    little.max_texture_2d = 4096;
    cpu->device().pretend(little);
    CHECK_THROWS_WITH_AS(Atmosphere(cpu->device(), presets::earth(), quality), doctest::Contains("device.max_texture_2d"),
                         Error);
    CHECK_NOTHROW(Atmosphere(cpu->device(), presets::earth(), single_alone(quality)));
    cpu->device().pretend(std::optional<rhi::Capabilities>{});
}

TEST_CASE("aureole without multiple scattering: the air asks for nothing of its settings") {
    const QualitySettings asked = single_alone(QualitySettings::high());
    for (const char* preset : {"earth", "mars", "titan", "airless"})
        CHECK(models::aureole(asked)->quality_for(presets::by_name(preset)) == asked);
}

TEST_CASE("aureole: in air that hardly scatters twice it makes no difference, in Earth's it does") {
    AtmosphereParameters thin = with_albedo(presets::earth(), 0);
    for (DensityTerm& term : thin.terms) {
        term.scattering_per_m *= 1e-4;
        term.absorption_per_m *= 1e-4;
    }
    const QualitySettings all = QualitySettings::standard();
    for (const AtmosphereParameters& air : {thin, presets::earth()}) {
        Sky with(physics::cpu_float(), air, of(models::aureole(all)));
        Sky without(physics::cpu_float(), air, of(models::aureole(single_alone(all))));
        Sky black(physics::cpu_float(), air, of(models::aureole(without_ground_light(all))));
        for (const double elevation : {60.0, 5.0, -2.0}) {
            CAPTURE(elevation);
            const std::vector<double> again = percents(without, with, 200, elevation);
            const std::vector<double> ground = percents(black, with, 200, elevation);
            if (air == thin) {
                CHECK(again.back() < 0.3);
                CHECK(ground.back() == 0);  // it is black
            } else {
                CHECK(again[again.size() / 2] > 5);
                if (elevation > 0) CHECK(ground[ground.size() / 2] > 0.3);
            }
        }
    }
}

namespace {

/// Rows above the horizon of all layers of the sky-view table; with the optical depths both halves would be the same.
Image upper_half(const Image& table, std::uint32_t rows) {
    Image result{{table.extent.width, table.extent.height / 2, 1}, {}};
    for (std::uint32_t y = 0; y < table.extent.height; ++y)
        for (std::uint32_t x = 0; x < table.extent.width && y % rows >= rows / 2; ++x) result.texels.push_back(table.at(x, y));
    return result;
}

struct Tables {
    Image moments, sky, froxels;
};
Tables tables(Backend& backend, const AtmosphereParameters& air, const QualitySettings& quality) {
    Setup setup;
    setup.air = air;
    setup.quality = quality;
    Rig rig(backend, setup);
    rig.record_air();
    rig.record_view(camera_at(air.planet, 200), sun_at(20));
    return {rig.multi_scatter(), rig.sky_view(), rig.froxels()};
}

}  // namespace

TEST_CASE(
    "aureole without the ground's light: air and sky are, to the bit, those over black ground; the ground is what it was") {
    Backends backends;
    const QualitySettings all = small_quality(), without = without_ground_light(all);
    backends.each([&](Backend& backend) {
        CAPTURE(backend.name());
        for (const AtmosphereParameters& air : {presets::earth(), presets::mars()}) {
            const Tables black = tables(backend, with_albedo(air, 0), all);
            const Tables dark = tables(backend, with_albedo(air, 0.45), without);
            const Tables bright = tables(backend, with_albedo(air, 0.9), without);
            const Tables lit = tables(backend, with_albedo(air, 0.9), all);
            const std::uint32_t rows = all.sky_view.height;
            for (const Tables* each : {&dark, &bright}) {
                CHECK(each->moments == black.moments);
                CHECK(each->froxels == black.froxels);
                CHECK(upper_half(each->sky, rows) == upper_half(black.sky, rows));
            }
            CHECK(lit.moments != black.moments);
            CHECK(lit.froxels != black.froxels);
            CHECK(upper_half(lit.sky, rows) != upper_half(black.sky, rows));
            // Layer 0 below the horizon: in proportion to the albedo, what the ground sends.
            Worst linear;
            for (std::uint32_t y = 0; y < rows / 2; ++y)
                for (std::uint32_t x = 0; x < black.sky.extent.width; ++x)
                    for (int c = 0; c < 3; ++c) {
                        const double air_alone = black.sky.at(x, y)[c];
                        const double half = dark.sky.at(x, y)[c] - air_alone, whole = bright.sky.at(x, y)[c] - air_alone;
                        CHECK(half >= 0);
                        linear.add(std::abs(whole - 2 * half) / (std::abs(whole) + air_alone), whole, 2 * half, "");
                    }
            INFO(linear.text());
            CHECK(linear.error() < 1e-5);
            const glm::dvec4 nadir = bright.sky.at(0, rows / 2 - 1), over_black = black.sky.at(0, rows / 2 - 1);
            CHECK(nadir.x > 3 * over_black.x);
            CHECK(nadir.x < lit.sky.at(0, rows / 2 - 1).x);  // the sky over black ground is darker
        }
    });
}

TEST_CASE("aureole without the ground's light, in N wavelengths: the sky over black ground") {
    const models::SpectralSettings four{.wavelengths = spectrum::fitted(4)};
    const QualitySettings all = small_quality();
    Sky expected(physics::cpu_double(), with_albedo(presets::earth(), 0), of(models::spectral(models::aureole(all), four)));
    Sky sky(physics::cpu_double(), with_albedo(presets::earth(), 0.9),
            of(models::spectral(models::aureole(without_ground_light(all)), four)));
    for (Sky* each : {&expected, &sky}) each->stand(200, physics::sun_at(60 * degree));
    std::vector<glm::dvec3> up = views();
    std::erase_if(up, [](const glm::dvec3& view) { return view.z < 0; });
    CHECK(sky.radiance(up) == expected.radiance(up));
    const glm::dvec3 down(0, 0, -1);
    CHECK(physics::sum(sky.radiance(down)) > 2 * physics::sum(expected.radiance(down)));
}

TEST_CASE("aureole without multiple scattering, or without the ground's light: every backend shows the same, at every hour") {
    Backends backends;
    check_model(backends, models::aureole(single_alone(small_quality())), "aureole, single scattering alone");
    check_model(backends, models::aureole(without_ground_light(small_quality())), "aureole, ground light off");
}
