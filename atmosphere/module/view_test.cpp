// View: what it records and when, and what stays as it was.
#include <doctest/doctest.h>

#include <array>

#include "common/rejects.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

const Planet earth = presets::earth().planet;
constexpr rhi::Extent size{19, 11, 1};

Setup setup_of(std::uint32_t suns = 1) {
    Setup setup;
    setup.view.max_suns = suns;
    setup.composite.target_format = rhi::Format::rgba32_float;
    return setup;
}

/// Which passes the latest View::record recorded, as letters: s(ky-view), f(roxels), l(ight).
std::string recorded(const Rig& rig) {
    std::string passes;
    for (int i = 0; i < 3; ++i)
        if (rig.view.reports()[static_cast<std::size_t>(i)].recorded) passes += "sfl"[i];
    return passes;
}

}  // namespace

TEST_CASE("view: records only what follows from the change") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of());
    rig.record_air();
    Camera camera = camera_at(earth, 100);
    Sun sun = sun_at(30);
    CHECK(rig.record_view(camera, sun).dispatches == 3);
    CHECK(recorded(rig) == "sfl");
    CHECK(rig.record_view(camera, sun).total() == 0);
    CHECK(recorded(rig) == "");

    camera.view = look(earth.bottom_radius_m, 100, 1.2, 0.1, 1, 1.5).view;  // turned
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "f");
    camera.projection = look(earth.bottom_radius_m, 100, 0, 0, 0.5, 1.5).projection;  // zoomed
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "f");
    sun.irradiance = {3, 2, 1};
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "l");
    sun.direction = {0, std::cos(0.5), std::sin(0.5)};  // another azimuth and height
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "sfl");
    sun.limb_darkening = LimbDarkening::none;
    rig.record_view(camera, sun);
    CHECK(recorded(rig).find('s') == std::string::npos);
    CHECK(recorded(rig).find('f') == std::string::npos);
    rig.view.set_exposure(2);
    CHECK(rig.record_view(camera, sun).dispatches == 0);
    CHECK(recorded(rig) == "");
    camera.position_m.z += 1;
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "sfl");
    CHECK(rig.record_view(camera, sun).total() == 0);

    AtmosphereParameters air = rig.setup.air;
    air.planet.ground_albedo = Rgb(0.8);
    rig.air.set_parameters(air);
    rig.record_air();
    rig.record_view(camera, sun);
    CHECK(recorded(rig) == "sfl");
    CHECK(rig.record_air().total() + rig.record_view(camera, sun).total() == 0);
}

TEST_CASE("view: while a solution is spread over frames it follows the finished tables") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of());
    const Camera camera = camera_at(earth, 100);
    rig.record_air();
    rig.record_view(camera, sun_at(30));
    AtmosphereParameters air = rig.setup.air;
    air.planet.ground_albedo = Rgb(0.1);
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.air.set_parameters(air);
    std::string passes;
    for (int frame = 0; frame < 4; ++frame) {
        rig.record_air();
        rig.record_view(camera, sun_at(30));
        passes += recorded(rig) + ",";
    }
    CHECK(passes == "sfl,,sfl,,");  // new transmittance, then new multi-scatter

    Setup setup = setup_of();
    setup.air = air;
    Rig made(*cpu, setup);
    made.record_air();
    made.record_view(camera, sun_at(30));
    CHECK(rig.sky_view() == made.sky_view());
    CHECK(rig.froxels() == made.froxels());
}

TEST_CASE("view: what it is not asked for is neither made nor recorded") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of();
    setup.view.aerial_perspective = false;
    setup.view.light = false;
    Rig rig(*cpu, setup);
    rig.record_air();
    CHECK(rig.record_view(camera_at(earth, 100), sun_at(30)).dispatches == 1);
    CHECK(recorded(rig) == "s");
    Camera turned = camera_at(earth, 100);
    turned.view = look(earth.bottom_radius_m, 100, 1.2, 0.1, 1, 1.5).view;
    CHECK(rig.record_view(turned, sun_at(30)).dispatches == 0);
    CHECK(!rig.view.light_table());
    Setup full = setup_of();
    Rig whole(*cpu, full);
    CHECK(rig.view.table_bytes() < whole.view.table_bytes());
}

TEST_CASE("view: several views share the air's tables and have their own") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of());
    auto second = std::make_unique<View>(rig.air);
    View third(rig.air, {.max_suns = 2});
    rig.record_air();
    const Camera cameras[] = {camera_at(earth, 0), camera_at(earth, 5e3), camera_at(earth, 4e5)};
    const Sun suns[] = {sun_at(30), sun_at(2)};
    const CommandCounts counts = cpu->run([&](rhi::CommandList& commands) {
        rig.view.update(cameras[0], std::span(suns, 1));
        second->update(cameras[1], std::span(suns, 1));
        third.update(cameras[2], suns);
        rig.air.record(commands);
        rig.view.record(commands);
        second->record(commands);
        third.record(commands);
    });
    CHECK(counts.dispatches == 9);  // three passes a view; the air's tables stand
    Rig alone(*cpu, setup_of());
    alone.record_air();
    alone.record_view(cameras[1], suns[0]);
    CHECK(cpu->read(second->sky_view_table()) == alone.sky_view());
    CHECK(cpu->read(second->aerial_perspective_table()) == alone.froxels());
    CHECK(rig.view.sky_view_table() != second->sky_view_table());
    second.reset();
    rig.air.set_parameters(presets::mars());  // the views that are left follow
    cpu->run([&](rhi::CommandList& commands) {
        rig.air.record(commands);
        rig.view.record(commands);
        third.record(commands);
    });
    Setup mars = setup_of();
    mars.air = presets::mars();
    Rig made(*cpu, mars);
    made.record_air();
    made.record_view(cameras[0], suns[0]);
    CHECK(rig.sky_view() == made.sky_view());
}

TEST_CASE("view: refused cameras, suns and settings change nothing") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of());
    rig.record_air();
    const Camera camera = camera_at(earth, 100);
    const Sun sun = sun_at(30), dark = [] {
        Sun s = sun_at(30);
        s.irradiance.z = -1;
        return s;
    }();
    rig.record_view(camera, sun);
    Camera fisheye = camera, nowhere = camera;
    fisheye.kind = Projection::fisheye;
    nowhere.position_m = glm::dvec3(0);
    const auto field = [&](const Camera& c, std::span<const Sun> s) {
        return detail::rejected_field([&] { rig.view.update(c, s); });
    };
    CHECK(field(fisheye, std::span(&sun, 1)) == "camera.kind");
    CHECK(field(nowhere, std::span(&sun, 1)) == "camera.position_m");
    CHECK(field(camera, std::span(&dark, 1)).find("irradiance") != std::string::npos);
    const Sun two[] = {sun, sun};
    CHECK(field(camera, two) == "suns");
    CHECK(cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands); }).total() == 0);

    const std::uint64_t live = cpu->device().live();
    CHECK(detail::rejected_field([&] { View view(rig.air, {.max_suns = 5}); }) == "view.max_suns");
    CHECK(detail::rejected_field([&] { View view(rig.air, {.aerial_perspective_distance_m = -1}); }) ==
          "view.aerial_perspective_distance_m");
    CHECK(detail::rejected_field([&] { View view(rig.air, {}, {.exposure = 0}); }) == "composite.exposure");
    for (const rhi::Format format : {rhi::Format::d32_float, rhi::Format::undefined, static_cast<rhi::Format>(99)})
        CHECK(detail::rejected_field([&] { View view(rig.air, {}, {.target_format = format}); }) == "composite.target_format");
    CHECK(detail::rejected_field([&] { View view(rig.air, {.projection = static_cast<Projection>(7)}); }) == "view.projection");
    CHECK(detail::rejected_field([&] { View view(rig.air, {}, {.tone_map = static_cast<ToneMap>(2)}); }) ==
          "composite.tone_map");
    CHECK(cpu->device().live() == live);
}

TEST_CASE("view: tables that the device cannot hold are refused by the setting that makes them so high") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of();
    setup.quality.sky_view.height = 1000;
    setup.quality.aerial_perspective.height = 64;
    AirRig rig(*cpu, setup);
    rhi::Capabilities less = cpu->device().capabilities();
    less.max_texture_2d = 4096;
    less.max_texture_3d = 256;
    cpu->device().pretend(less);
    const std::uint64_t live = cpu->device().live();
    const auto refused = [&](const ViewSettings& settings) -> std::string {
        try {
            View view(rig.air, settings);
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::unsupported);
            CHECK(cpu->device().live() == live);
            return error.field() + ": " + error.value() + "; " + error.allowed();
        }
        return "nothing";
    };
    CHECK(refused({.max_suns = 1}) == "nothing");
    CHECK(refused({.max_suns = 2}) ==
          "aureole.sky_view.height: 1000 with view.max_suns 2; at most 819 (device.max_texture_2d 4096, shared by 5 layers), "
          "or fewer "
          "suns");
    less.max_texture_2d = 16384;
    cpu->device().pretend(less);
    CHECK(refused({.max_suns = 2}) ==
          "aureole.aerial_perspective.height: 64 with view.max_suns 2; at most 51 (device.max_texture_3d 256, shared by 5 "
          "layers), or "
          "fewer suns");
    CHECK(refused({.max_suns = 2, .aerial_perspective = false}) == "nothing");

    // The same for air that has more layers than before.
    const View view(rig.air);
    AtmosphereParameters more = setup.air;
    for (const double g : {0.5, 0.6})
        more.terms.push_back(
            {.name = "smoke", .profile = {}, .scattering_per_m = Rgb(1e-6), .phase = HenyeyGreensteinPhase{g}});
    const std::uint64_t with_view = cpu->device().live();
    try {
        rig.air.set_parameters(more);
        CHECK_MESSAGE(false, "not refused");
    } catch (const Error& error) {
        CHECK(error.field() == "aureole.aerial_perspective.height");
    }
    CHECK(rig.air.parameters() == setup.air);
    CHECK(cpu->device().live() == with_view);
}

TEST_CASE("view: composites need their textures") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of();
    setup.composite.scene_color = setup.composite.scene_depth = true;
    Rig rig(*cpu, setup);
    const rhi::Texture target = cpu->make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write);
    const rhi::Texture scene = cpu->make("scene", rhi::Format::rgba32_float, {size, std::vector<glm::dvec4>(19 * 11)});
    const auto field = [&](const CompositeTargets& targets) {
        return detail::rejected_field([&] { rig.view.prepare_composite(targets); });
    };
    const std::uint64_t live = cpu->device().live();
    CHECK(field({.scene_color = scene, .scene_depth = scene, .extent = size}) == "targets.target");
    CHECK(field({.scene_depth = scene, .target = target, .extent = size}) == "targets.scene_color");
    CHECK(field({.scene_color = scene, .target = target, .extent = size}) == "targets.scene_depth");
    CHECK(field({.scene_color = scene, .scene_depth = scene, .target = target, .extent = {0, 4, 1}}) == "targets.extent.width");
    // Sizes that the device knows.
    const rhi::Texture small = cpu->make("small", rhi::Format::rgba32_float, {{8, 11, 1}, std::vector<glm::dvec4>(8 * 11)});
    const std::uint64_t with_small = cpu->device().live();
    CHECK(field({.scene_color = scene, .scene_depth = scene, .target = target, .extent = {8, 11, 1}}) == "targets.extent");
    CHECK(field({.scene_color = small, .scene_depth = scene, .target = target, .extent = size}) == "targets.scene_color");
    CHECK(field({.scene_color = scene, .scene_depth = small, .target = target, .extent = size}) == "targets.scene_depth");
    CHECK(field({.scene_color = scene, .scene_depth = scene, .target = target, .directions = small, .extent = size}) ==
          "targets.directions");
    // A format that the kernels were not made for, and a target that is read as well.
    const rhi::Texture bytes = cpu->make_target(rhi::Format::rgba8_unorm, size, rhi::State::storage_write);
    const std::uint64_t with_bytes = cpu->device().live();
    try {
        rig.view.prepare_composite({.scene_color = scene, .scene_depth = scene, .target = bytes, .extent = size});
        CHECK_MESSAGE(false, "not refused");
    } catch (const Error& error) {
        CHECK(std::string(error.what()) ==
              "targets.target: rgba8_unorm is not allowed; allowed: rgba32_float, "
              "CompositeSettings::target_format");
    }
    CHECK(field({.scene_color = target, .scene_depth = scene, .target = target, .extent = size}) == "targets.scene_color");
    CHECK(field({.scene_color = scene, .scene_depth = target, .target = target, .extent = size}) == "targets.scene_depth");
    CHECK(field({.scene_color = scene, .scene_depth = scene, .target = target, .directions = target, .extent = size}) ==
          "targets.directions");
    CHECK(cpu->device().live() == with_bytes);
    CHECK(with_small == live + 1);
    CHECK(field({.scene_color = scene, .scene_depth = scene, .target = target, .extent = size}) == "nothing");
}

TEST_CASE("view: composites stay prepared over a change of air, the last sixteen in use") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of());
    rig.record_air();
    rig.record_view(camera_at(earth, 100), sun_at(30));
    std::vector<CompositeTargets> targets;
    const auto record = [&](const CompositeTargets& t) {
        return cpu->run([&](rhi::CommandList& commands) { rig.view.record_composite(commands, t); }).dispatches;
    };
    for (int i = 0; i < 17; ++i) {
        targets.push_back(
            {.target = cpu->make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write), .extent = size});
        rig.view.prepare_composite(targets.back());
        CHECK(record(targets.front()) == 1);  // the first one is in use all the time
    }
    const auto prepared = [&] {
        std::uint64_t count = 0;
        for (const CompositeTargets& t : targets) count += record(t);
        return count;
    };
    CHECK(prepared() == 16);
    CHECK(record(targets[0]) == 1);
    CHECK(record(targets[1]) == 0);
    rig.air.set_parameters(presets::mars());
    rig.record_air();
    cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands); });
    CHECK(prepared() == 16);
    CHECK(record(targets[1]) == 0);

    // Textures that the host has destroyed do not stand in the way, once they have been released.
    const rhi::Texture gone =
        cpu->device().create_texture({"gone", rhi::Dimension::d2, rhi::Format::rgba32_float, size, rhi::Usage::storage});
    const CompositeTargets lost{.target = gone, .extent = size};
    rig.view.prepare_composite(lost);
    rig.view.release_composite(lost);
    cpu->device().destroy(gone, 0);
    CHECK_NOTHROW(rig.air.set_parameters(presets::earth()));
    CHECK(record(lost) == 0);
}
