// The path tracer's light: the same on every backend, the sky's, traced again when it must be.
#include <aureole/models/reference.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

Setup lit_setup(int light_paths, const char* preset = "earth") {
    models::ReferenceSettings settings;
    settings.light_paths = light_paths;
    settings.first_order_parts = 2;
    settings.nodes = 8;
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = models::reference(settings);
    setup.composite.target_format = rhi::Format::rgba32_float;
    return setup;
}

}  // namespace

TEST_CASE("reference: every backend has the same light") {
    Backends backends;
    for (const char* preset : {"earth", "mars"}) {
        Trio<Rig> trio(backends, lit_setup(8, preset));
        for (const auto& place : {std::pair(2.0, 30.0), {2.0, -3.0}, {3e5, 5.0}}) {
            const double altitude = place.first, elevation = place.second;
            trio.each([&](Rig& rig) {
                rig.record_air();
                rig.record_view(camera_at(rig.setup.air.planet, altitude), sun_at(elevation));
            });
            const Images light = trio.read(&Rig::light);
            const auto check_light = [](const Image& a, const Image& b, const std::string& where) {
                INFO(where);
                std::vector<double> apart;
                for (std::uint32_t x = 0; x < 9; ++x)
                    for (int c = 0; c < 3; ++c) apart.push_back(std::abs(a.at(x, 0)[c] - b.at(x, 0)[c]) / b.at(0, 0)[c]);
                std::ranges::sort(apart);
                CHECK(b.at(0, 0).g > 1e-6);
                CHECK(apart[apart.size() / 2] < 1e-4);
                CHECK(apart.back() < 5e-3);  // another path here and there
                for (int c = 0; c < 3; ++c) CHECK(std::abs(a.at(9, 0)[c] - b.at(9, 0)[c]) <= 1e-4 * b.at(9, 0)[c]);
            };
            const std::string where = place_name(preset, altitude, elevation);
            check_light(light.single, light.exact, where + ": float and double");
            if (light.vulkan) check_light(*light.vulkan, light.single, where + ": Vulkan and float");
        }
    }
}

TEST_CASE("reference: the light is the sky's, summed up over a picture all around") {
    const auto cpu = open_cpu_float();
    Setup setup = lit_setup(40);  // in two parts
    std::erase_if(setup.air.terms, [](const DensityTerm& term) { return term.name != "rayleigh" && term.name != "ozone"; });
    setup.view.projection = Projection::panorama;
    setup.composite.sun_disk = false;
    Rig rig(*cpu, setup);
    rig.record_air();
    Camera camera = camera_at(setup.air.planet, 200);
    camera.kind = Projection::panorama;
    rig.record_view(camera, sun_at(30));
    constexpr rhi::Extent all{48, 48, 1};
    const Image sky = rig.show(all), light = rig.light();
    glm::dvec4 first(0), rising(0);
    for (std::uint32_t y = 0; y < all.height; ++y) {
        const double elevation = std::numbers::pi * (0.5 - (y + 0.5) / all.height);
        const double weight = 2 * std::numbers::pi / all.width * std::numbers::pi / all.height * std::cos(elevation);
        for (std::uint32_t x = 0; x < all.width; ++x) {
            first += sky.at(x, y) * (weight * std::sqrt(0.25 / std::numbers::pi));
            rising += sky.at(x, y) * (weight * std::sqrt(0.75 / std::numbers::pi) * std::sin(elevation));
        }
    }
    for (int c = 0; c < 3; ++c) {
        CHECK(light.at(0, 0)[c] == doctest::Approx(first[c]).scale(1e-300).epsilon(0.02));
        CHECK(std::abs(light.at(2, 0)[c] - rising[c]) < 0.02 * first[c]);
    }
}

TEST_CASE("reference: the light is traced again when air, camera or suns change, and only then") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, lit_setup(2));
    const auto traced = [&](double altitude, double elevation, double turn = 0) {
        rig.record_air();
        Camera camera = camera_at(rig.setup.air.planet, altitude);
        camera.view = camera.view * glm::rotate(glm::dmat4(1), turn, glm::dvec3(0, 0, 1));
        rig.record_view(camera, sun_at(elevation));
        CHECK(rig.view.reports()[0].name == "light paths");
        return rig.view.reports()[0].recorded;
    };
    CHECK(traced(100, 20));
    const Image light = rig.light();
    CHECK(!traced(100, 20));
    CHECK(!traced(100, 20, 1));  // whither it looks does not matter
    CHECK(traced(200, 20));
    CHECK(traced(200, 30));
    rig.air.set_parameters(presets::mars());
    CHECK(traced(100, 20));
    CHECK(!(rig.light() == light));
    rig.air.set_parameters(presets::earth());
    CHECK(traced(100, 20));
    CHECK(rig.light() == light);
    rig.view.invalidate();
    CHECK(traced(100, 20));
    CHECK(rig.light() == light);
}
