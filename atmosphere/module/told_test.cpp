// What is told to the log, once: what leaves the envelope of stability, misplaced cameras, recordings that come too early.
#include "passes/rig.h"

#include <aureole/envelope.h>
#include <aureole/models/bruneton.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/single.h>
#include <aureole/presets.h>
#include <aureole/rhi/log.h>

#include <doctest/doctest.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>
#include <array>
#include <memory>
#include <sstream>
#include <string>

using namespace aureole;
using namespace aureole::passes;

namespace {

/// What is logged by `does`.
template <class Does>
std::string logged(const Does& does) {
    std::ostringstream text;
    set_log(std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(text)));
    does();
    set_log(nullptr);
    return text.str();
}
std::size_t count(const std::string& text, const std::string& part) {
    std::size_t times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
    return times;
}

AtmosphereParameters with_g(double g) {
    AtmosphereParameters air = presets::earth();
    air.terms[1].phase = HenyeyGreensteinPhase{g};
    return air;
}

}  // namespace

TEST_CASE("envelope: an air outside is told when it is set, and not again while it stays there") {
    const auto cpu = open_cpu_float();
    Setup setup;
    CHECK(logged([&] { Rig(*cpu, setup); }) == "");
    setup.air = with_g(0.995);
    const std::string made = logged([&] { Rig(*cpu, setup); });
    CAPTURE(made);
    CHECK(count(made, "[warning]") == 1);
    CHECK(count(made, "terms[1].phase.g: 0.995 is outside the envelope of stability, [-0.99, 0.99]: expect errors") == 1);

    setup.air = with_g(0.9);
    Rig rig(*cpu, setup);
    const auto set = [&](double g, double albedo) {
        AtmosphereParameters air = with_g(g);
        air.planet.ground_albedo = Rgb(albedo);
        return logged([&] { rig.air.set_parameters(air); });
    };
    CHECK(set(0.98, 0.3) == "");
    CHECK(count(set(-0.995, 0.3), "terms[1].phase.g: -0.995") == 1);
    CHECK(set(-0.998, 0.4) == "");  // still so
    CHECK(set(0.5, 0.4) == "");
    CHECK(count(set(0.999, 0.4), "terms[1].phase.g: 0.999") == 1);
}

TEST_CASE("envelope: a camera outside, and twilight in half floats") {
    const auto cpu = open_cpu_float();
    Setup setup;
    Rig whole(*cpu, setup);
    setup.model = models::hillaire({});
    Rig half(*cpu, setup);
    const auto told = [&](Rig& rig, double altitude_m, double elevation_deg) {
        const std::array suns{sun_at(elevation_deg)};
        return logged([&] { rig.view.update(camera_at(setup.air.planet, altitude_m), suns); });
    };
    CHECK(told(whole, 100, 30) == "");
    CHECK(told(whole, 100, -17) == "");
    CHECK(count(told(whole, 2e9, 30), "camera.position_m: altitude in m: 2") == 1);
    CHECK(told(whole, 3e9, 30) == "");
    CHECK(told(whole, 10, 30) == "");

    CHECK(told(half, 100, -8) == "");
    CHECK(count(told(half, 100, -12), "suns[0].direction: elevation in degrees: -1") == 1);
    CHECK(told(half, 100, -13) == "");
    CHECK(told(half, 100, -5) == "");
    CHECK(count(told(half, 100, -14), "suns[0].direction") == 1);
}

TEST_CASE("envelope: a dome in half floats is the camera's sky too") {
    const auto cpu = open_cpu_float();
    const auto told = [&](rhi::Format format) {
        Setup setup;
        models::SingleSettings settings;
        settings.dome = {.size = {8, 16, 1}, .phase = models::Dome::Phase::in_table, .format = format};
        setup.model = models::single(settings);
        Rig rig(*cpu, setup);
        const std::array suns{sun_at(-12)};
        return logged([&] { rig.view.update(camera_at(setup.air.planet, 100), suns); });
    };
    CHECK(told(rhi::Format::rgba32_float) == "");
    CHECK(count(told(rhi::Format::rgba16_float), "suns[0].direction: elevation in degrees: -1") == 1);
}

TEST_CASE("envelope: two views of an air say the same but once, and another value by itself") {
    const auto cpu = open_cpu_float();
    const Setup setup;
    Rig rig(*cpu, setup);
    View second(rig.air, setup.view, setup.composite);
    const std::array suns{sun_at(30)};
    const auto told = [&](View& view, double altitude_m) {
        return logged([&] { view.update(camera_at(setup.air.planet, altitude_m), suns); });
    };
    CHECK(count(told(rig.view, 2e9), "camera.position_m: altitude in m: 2") == 1);
    CHECK(told(second, 2e9) == "");
    CHECK(told(rig.view, 10) == "");
    CHECK(told(second, 10) == "");
    CHECK(count(told(second, 2e9), "camera.position_m: altitude in m: 2") == 1);
    CHECK(count(told(rig.view, 4e9), "camera.position_m: altitude in m: 4") == 1);
}

TEST_CASE("envelope: what a view said that is gone is said again, unless one that is left is outside with it") {
    const auto cpu = open_cpu_float();
    const Setup setup;
    Rig rig(*cpu, setup);
    const std::array suns{sun_at(30)};
    const auto told = [&](View& view) { return logged([&] { view.update(camera_at(setup.air.planet, 2e9), suns); }); };
    const auto made = [&] { return std::make_unique<View>(rig.air, setup.view, setup.composite); };
    const std::string warning = "camera.position_m: altitude in m: 2";
    auto first = made();
    CHECK(count(told(*first), warning) == 1);
    first.reset();
    auto second = made();
    CHECK(count(told(*second), warning) == 1);
    auto third = made();
    CHECK(told(*third) == "");
    second.reset();
    CHECK(told(*made()) == "");
    third.reset();
    CHECK(count(told(*made()), warning) == 1);
}

TEST_CASE("envelope: geometry at dusk by differences of half floats, where there is geometry") {
    const auto cpu = open_cpu_float();
    const auto told = [&](rhi::Format format, bool geometry) {
        Setup setup;
        models::BrunetonSettings settings;
        settings.format = format;
        setup.model = models::bruneton(settings);
        setup.composite.scene_color = setup.composite.scene_depth = geometry;
        Rig rig(*cpu, setup);
        const std::array suns{sun_at(-4)};
        return logged([&] { rig.view.update(camera_at(setup.air.planet, 100), suns); });
    };
    CHECK(count(told(rhi::Format::rgba16_float, true), "suns[0].direction: elevation in degrees, of geometry: -") == 1);
    CHECK(told(rhi::Format::rgba16_float, false) == "");
    CHECK(told(rhi::Format::rgba32_float, true) == "");
}

TEST_CASE("view: recording too early says so, once until it can record, and records nothing") {
    const auto cpu = open_cpu_float();
    Setup setup;
    setup.composite.target_format = rhi::Format::rgba32_float;
    Rig rig(*cpu, setup);
    constexpr rhi::Extent size{19, 11, 1};
    const CompositeTargets targets{.target = cpu->make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write),
                                   .extent = size};
    rig.view.prepare_composite(targets);
    std::uint64_t commands_recorded = 0;
    const auto record = [&] {
        return logged(
            [&] { commands_recorded = cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands); }).total(); });
    };
    const auto compose = [&](const CompositeTargets& t) {
        return logged([&] {
            commands_recorded = cpu->run([&](rhi::CommandList& commands) { rig.view.record_composite(commands, t); }).total();
        });
    };
    const auto told_once = [&](const auto& does, const char* text) {
        CHECK(count(does(), text) == 1);
        CHECK(does() == "");
        CHECK(commands_recorded == 0);
    };
    told_once(record, "View::record: called before View::update");
    rig.view.update(camera_at(setup.air.planet, 100), std::array{sun_at(30)});
    told_once(record, "View::record: called before Atmosphere::record");
    rig.record_air();
    told_once([&] { return compose(targets); }, "View::record_composite: called before View::record");
    CHECK(!rig.view.reports()[3].recorded);
    CHECK(record() == "");
    CHECK(commands_recorded > 0);
    CHECK(compose(targets) == "");
    CHECK(commands_recorded > 0);

    CompositeTargets narrow = targets, flat = targets;
    narrow.extent.width = 7;
    flat.extent.height = 7;
    for (const CompositeTargets& others : {narrow, flat, CompositeTargets{}})
        told_once([&] { return compose(others); }, "not given to prepare_composite");
    CHECK(compose(narrow) == "");  // told before those in between
    CHECK(!rig.view.reports()[3].recorded);
    rig.view.release_composite(targets);
    told_once([&] { return compose(targets); }, "not given to prepare_composite");
    rig.view.prepare_composite(targets);
    rig.view.release_composite(targets);
    told_once([&] { return compose(targets); }, "not given to prepare_composite");  // prepared in between

    rig.air.invalidate();  // and too early once more
    told_once(record, "View::record: called before Atmosphere::record");
}

TEST_CASE("view: a camera deep inside the planet is told to the log, once a change") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, {});
    const Planet planet = rig.setup.air.planet;
    const Sun sun = sun_at(30);
    const auto told = [&](double altitude_m) {
        Camera camera = camera_at(planet, 0);
        camera.position_m.z += altitude_m;
        return logged([&] { rig.view.update(camera, {&sun, 1}); });
    };
    CHECK(told(100) == "");
    CHECK(told(-0.49 * planet.bottom_radius_m) == "");
    // As if the position were relative to an origin on the ground.
    const std::string text = told(-planet.bottom_radius_m + 2);
    CAPTURE(text);
    CHECK(text.find("camera.position_m: 2 m from the planet's centre") != std::string::npos);
    CHECK(text.find("in metres, relative to that centre (kilometres? the radius not added?)") != std::string::npos);
    CHECK(told(-planet.bottom_radius_m + 3) == "");  // still so
    CHECK(told(100) == "");
    CHECK(told(-planet.bottom_radius_m + 2) != "");
}
