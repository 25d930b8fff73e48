// Fog against its closed forms, and on every backend.
#include <aureole/models/fog.h>

#include "common/rejects.h"
#include "passes/model_sweep.h"
#include "passes/scene.h"
#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <limits>

using namespace aureole;
using models::FogSettings;
using physics::apart;
using physics::cpu_double;
using physics::cpu_float;
using physics::degree;
using physics::direction;
using physics::Sky;
using physics::sun_at;

namespace {

FogSettings one_colour(FogSettings::Sky sky) {
    FogSettings settings;
    settings.mode = FogSettings::Mode::one_colour;
    settings.sky = sky;
    settings.colour = {0.3, 0.2, 0.1};
    settings.density_per_m = 2e-5;
    return settings;
}

physics::SkyOptions of(const FogSettings& settings) {
    physics::SkyOptions options;
    options.model = models::fog(settings);
    return options;
}

std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> result;
    for (const double zenith : {0.0, 40.0, 80.0, 89.5, 95.0, 130.0, 180.0})
        for (const double azimuth : {0.0, 70.0, 180.0}) result.push_back(direction(zenith * degree, azimuth * degree));
    return result;
}

/// What an altitude of the earth's air scatters towards the camera, and what it takes away, per metre.
struct Air {
    Rgb source{0}, extinction{0};
};
Air air_at(const AtmosphereParameters& air, double altitude_m, double nu) {
    Air result;
    for (const DensityTerm& term : air.terms) {
        double density = 0;
        if (const auto* exponential = std::get_if<ExponentialProfile>(&term.profile))
            density = std::exp(-altitude_m / exponential->scale_height_m);
        else if (const auto* tent = std::get_if<TentProfile>(&term.profile))
            density = std::max(0.0, 1 - std::abs(altitude_m - tent->center_m) / tent->half_width_m);
        else
            FAIL("a profile that this test does not know");
        result.source += density * evaluate(term.phase, nu) * term.scattering_per_m;
        result.extinction += density * (term.scattering_per_m + term.absorption_per_m);
    }
    return result;
}

}  // namespace

TEST_CASE("fog of one colour: C (1 - exp(-density s)) before a black sky and ground") {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0);
    const physics::Shell shell;
    for (const FogSettings::Sky end : {FogSettings::Sky::top_of_air, FogSettings::Sky::infinity}) {
        const FogSettings settings = one_colour(end);
        Sky sky(cpu_float(), air, of(settings));
        physics::Worst worst;
        for (const double altitude : {2.0, 500.0, 20000.0}) {
            sky.stand(altitude, sun_at(50 * degree));
            const std::vector<glm::dvec3> views = directions();
            const std::vector<Rgb> seen = sky.radiance(views);
            for (std::size_t i = 0; i < views.size(); ++i) {
                const glm::dvec3& view = views[i];
                const bool ground = shell.hits_ground(altitude, view.z);
                double length = static_cast<double>(shell.to_end(altitude, view.z));
                if (end == FogSettings::Sky::infinity && !ground) length = std::numeric_limits<double>::infinity();
                const Rgb expected = settings.colour * (1 - std::exp(-settings.density_per_m * length));
                worst.add(apart(seen[i], expected), altitude, view.x, view.y, view.z);
            }
        }
        CHECK_WORST(worst, 1e-5);
    }
}

TEST_CASE("fog without end ends with the air for a camera in space") {
    const AtmosphereParameters air = presets::earth();
    std::vector<Rgb> seen[2];
    const std::vector<glm::dvec3> views = directions();
    for (const FogSettings::Sky end : {FogSettings::Sky::top_of_air, FogSettings::Sky::infinity}) {
        physics::SkyOptions options = of(one_colour(end));
        options.beyond = 3;
        Sky sky(cpu_float(), air, options);
        sky.stand(1e6, sun_at(50 * degree));
        seen[end == FogSettings::Sky::infinity ? 1 : 0] = sky.radiance(views);
    }
    for (std::size_t i = 0; i < views.size(); ++i) CHECK(seen[0][i] == seen[1][i]);
}

TEST_CASE("fog of one colour lets through exp(-density s) of what is behind it") {
    AtmosphereParameters air = presets::earth();
    const physics::Shell shell;
    const FogSettings settings = one_colour(FogSettings::Sky::top_of_air);
    physics::SkyOptions options = of(settings);
    options.beyond = 3;
    Sky sky(cpu_float(), air, options);
    sky.stand(500, sun_at(50 * degree));
    physics::Worst worst;
    for (const double zenith : {0.0, 60.0, 88.0}) {
        const glm::dvec3 view = direction(zenith * degree, 1);
        const double through = std::exp(-settings.density_per_m * static_cast<double>(shell.to_end(500, view.z)));
        worst.add(apart(sky.radiance(view), settings.colour * (1 - through) + Rgb(3 * through)), zenith);
    }
    CHECK_WORST(worst, 1e-5);
}

TEST_CASE("in-scatter: E sum b p / b_ex (1 - exp(-b_ex s)) with the air at the camera") {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0);
    physics::Shell shell;
    shell.bottom = air.planet.bottom_radius_m;
    shell.top = air.planet.top_radius_m;
    for (physics::Machine* machine : {&cpu_float(), &cpu_double()}) {
        physics::SkyOptions options = of({});
        options.light = true;
        Sky sky(*machine, air, options);
        physics::Worst worst;
        for (const double altitude : {2.0, 1500.0, 20000.0})
            for (const double sun_zenith : {0.0, 60.0, 88.0}) {
                sky.stand(altitude, sun_at(sun_zenith * degree, 0.0047));
                const Rgb sun_irradiance(sky.light().at(9));
                const std::vector<glm::dvec3> views = directions();
                const std::vector<Rgb> seen = sky.radiance(views);
                for (std::size_t i = 0; i < views.size(); ++i) {
                    const glm::dvec3& view = views[i];
                    const double nu = std::clamp(glm::dot(view, direction(sun_zenith * degree)), -1.0, 1.0);
                    const Air here = air_at(air, altitude, nu);
                    const double length = static_cast<double>(shell.to_end(altitude, view.z));
                    const Rgb expected =
                        sun_irradiance * here.source / here.extinction * (Rgb(1) - glm::exp(-here.extinction * length));
                    worst.add(apart(seen[i], expected), altitude, sun_zenith, view.x, view.y, view.z);
                }
            }
        CHECK_WORST(worst, 1e-4);
    }
}

TEST_CASE("in-scatter: the sun's irradiance is the table's, by quadrature") {
    const AtmosphereParameters air = presets::earth();
    const auto suns = [&](const ModelPtr& model) {
        physics::SkyOptions options;
        options.model = model;
        options.light = true;
        Sky sky(cpu_float(), air, options);
        std::vector<Rgb> result;
        for (const double altitude : {0.0, 3000.0, 90000.0, 300000.0})
            for (const double zenith : {0.0, 70.0, 88.0, 90.0, 95.0}) {
                sky.stand(altitude, sun_at(zenith * degree, 0.0047));
                result.emplace_back(sky.light().at(9));
            }
        return result;
    };
    const std::vector<Rgb> fog = suns(models::fog()), table = suns(models::aureole(QualitySettings::high()));
    physics::Worst worst;
    for (std::size_t i = 0; i < fog.size(); ++i) worst.add(glm::length(fog[i] - table[i]) / (glm::length(table[i]) + 1e-4), i);
    CHECK_WORST(worst, 5e-3);
}

TEST_CASE("fog before geometry: L0 F + S / b (1 - F), whichever the distance") {
    AtmosphereParameters air = presets::earth();
    physics::Picture picture(cpu_float(), air, models::fog(one_colour(FogSettings::Sky::infinity)), 1e4);
    const Sun sun = sun_at(50 * degree);
    picture.place(look(air.planet.bottom_radius_m, 500, 0, 0, 1, 4.0 / 3), {&sun, 1});
    const FogSettings settings = one_colour(FogSettings::Sky::infinity);
    physics::Worst worst;
    for (const double distance : {10.0, 1e3, 3e4, 2e5}) {
        const double through = std::exp(-settings.density_per_m * distance);
        for (const Rgb& color : picture.render(distance, Rgb(1, 2, 3)))
            worst.add(apart(color, settings.colour * (1 - through) + Rgb(1, 2, 3) * through), distance);
    }
    CHECK_WORST(worst, 1e-4);
}

TEST_CASE("fog over a forward renderer's colour and depth: the closed form in every depth convention, drawn or computed") {
    constexpr rhi::Extent extent{16, 10, 1};
    constexpr double aspect = 1.6;
    const FogSettings settings = one_colour(FogSettings::Sky::infinity);
    const auto backend = passes::open_cpu_float();
    const rhi::Texture color = backend->make(
        "color", rhi::Format::rgba32_float,
        passes::Image{extent, std::vector<glm::dvec4>(std::size_t{extent.width} * extent.height, glm::dvec4(1, 2, 3, 1))});
    for (const bool raster : {false, true})
        for (const passes::DepthConvention& convention : passes::perspective_conventions(aspect)) {
            CAPTURE(convention.name);
            passes::Setup setup;
            setup.model = models::fog(settings);
            setup.view.light = false;
            setup.composite = {
                .target_format = rhi::Format::rgba32_float, .raster = raster, .scene_color = true, .scene_depth = true};
            passes::Rig rig(*backend, setup);
            rig.record_air();
            Camera camera = look(setup.air.planet.bottom_radius_m, 300, 0, 0.8, 1, aspect);  // no bare ground in sight
            camera.projection = convention.projection;
            camera.depth_range = convention.range;
            rig.record_view(camera, sun_at(50 * degree));
            const passes::SceneTextures scene = passes::upload(*backend, extent, passes::patches, convention);
            const passes::Image image = rig.show(extent, {.scene_color = color, .scene_depth = scene.depth});
            physics::Worst worst;
            for (std::uint32_t y = 0; y < extent.height; ++y)
                for (std::uint32_t x = 0; x < extent.width; ++x) {
                    const glm::dvec3 ray((2 * (x + 0.5) / extent.width - 1) / convention.projection[0][0],
                                         (1 - 2 * (y + 0.5) / extent.height) / convention.projection[1][1], 1);
                    // Nothing there: endless fog, whatever colour the host has cleared to.
                    const double through = std::exp(-settings.density_per_m * passes::patches(x, y) * glm::length(ray));
                    worst.add(apart(Rgb(image.at(x, y)), settings.colour * (1 - through) + Rgb(1, 2, 3) * through), y);
                }
            CHECK_WORST(worst, 1e-3);
        }
}

TEST_CASE("fog: settings out of range are named") {
    const auto rejected = [](const auto& change) {
        FogSettings settings;
        change(settings);
        return detail::rejected_field([&] { (void)models::fog(settings); });
    };
    CHECK(rejected([](FogSettings& s) { s.mode = static_cast<FogSettings::Mode>(9); }) == "fog.mode");
    CHECK(rejected([](FogSettings& s) { s.sky = static_cast<FogSettings::Sky>(9); }) == "fog.sky");
    CHECK(rejected([](FogSettings& s) { s.colour.g = -1; }) == "fog.colour.g");
    CHECK(rejected([](FogSettings& s) { s.density_per_m = std::nan(""); }) == "fog.density_per_m");
    CHECK(rejected([](FogSettings& s) { s.transmittance_nodes = 17; }) == "fog.transmittance_nodes");
    CHECK(rejected([](FogSettings&) {}) == "nothing");
    CHECK(detail::rejected_field([] { (void)FogSettings::by_name("ultra"); }) == "quality");
}

TEST_CASE("fog: every backend shows the same, everywhere and at every hour") {
    passes::Backends backends;
    for (const std::string quality : {"low", "default"})
        passes::check_model(backends, models::fog(FogSettings::by_name(quality)), "fog " + quality);
}
