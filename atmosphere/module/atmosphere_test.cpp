// Atmosphere: what it records and when, what it refuses, and what a failure leaves behind.
#include <doctest/doctest.h>

#include <numbers>

#include "common/rejects.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

AtmosphereParameters with_albedo(double albedo) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(albedo);
    return air;
}

/// Earth with a layer of smoke: one more term, with a phase function of its own.
AtmosphereParameters smoky() {
    AtmosphereParameters air = presets::earth();
    air.terms.push_back({.name = "smoke",
                         .profile = TentProfile{3e3, 1e3},
                         .scattering_per_m = Rgb(2e-5),
                         .absorption_per_m = {1e-5, 2e-5, 3e-5},
                         .phase = HenyeyGreensteinPhase{0.6}});
    return air;
}

/// Earth whose ozone and dust come from tables of the user's.
AtmosphereParameters tabulated(double density) {
    AtmosphereParameters air = presets::earth();
    air.terms[1].phase = TabulatedPhase{{0, 0.3, 1.5, std::numbers::pi}, {30, 4, 1, 0.7}};
    air.terms[2].profile = TabulatedProfile{{0, 15e3, 30e3, 60e3}, {0.1, 0.5, density, 0}};
    return air;
}

Setup setup_of(const AtmosphereParameters& air) {
    Setup setup;
    setup.air = air;
    return setup;
}

/// Code and text of the error that a call throws; "nothing" if it throws none.
template <class Call>
std::string failure(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return std::string(to_string(error.code())) + ": " + error.what();
    }
    return "nothing";
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("atmosphere: records both tables once, then nothing until the air changes") {
    const auto cpu = open_cpu_float();
    AirRig rig(*cpu, {});
    CHECK(rig.record_air().dispatches > 2);
    REQUIRE(rig.air.reports().size() == 2);
    const PassReport first = rig.air.reports()[0], second = rig.air.reports()[1];
    CHECK(first.name == "transmittance");
    CHECK(first.recorded);
    CHECK(first.invocations == 40 * 12);
    CHECK(first.bytes_written == 40 * 12 * 16);
    CHECK(second.name == "multi_scatter");
    CHECK(second.recorded);
    CHECK(second.invocations > 0);
    CHECK(second.bytes_written > 0);

    for (int frame = 0; frame < 3; ++frame) {
        CHECK(rig.record_air().total() == 0);
        CHECK(!rig.air.reports()[0].recorded);
        CHECK(!rig.air.reports()[1].recorded);
    }
    rig.air.set_parameters(rig.air.parameters());  // nothing new
    CHECK(rig.record_air().total() == 0);
    rig.air.set_parameters(with_albedo(0.9));
    CHECK(rig.record_air().dispatches > 2);
    CHECK(rig.record_air().total() == 0);
}

TEST_CASE("atmosphere: a change ends in the tables of an atmosphere made so, and its views follow") {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        Rig changing(*backend, {});
        View other(changing.air);
        for (const AtmosphereParameters& air : {with_albedo(0.05), smoky(), tabulated(1), tabulated(0.2), presets::mars(),
                                                presets::airless(), presets::earth()}) {
            changing.air.set_parameters(air);
            changing.record_air();
            changing.record_view(camera_at(air.planet, 50), sun_at(12));
            Rig made(*backend, setup_of(air));
            made.record_air();
            made.record_view(camera_at(air.planet, 50), sun_at(12));
            CHECK(changing.air.parameters() == air);
            CHECK(changing.transmittance() == made.transmittance());
            CHECK(changing.multi_scatter() == made.multi_scatter());
            CHECK(changing.sky_view() == made.sky_view());
            CHECK(changing.froxels() == made.froxels());
            CHECK(changing.light() == made.light());
            CHECK(changing.air.table_bytes() == made.air.table_bytes());
        }
    }
}

TEST_CASE("atmosphere: says how much memory its tables take") {
    const auto cpu = open_cpu_float();
    const std::uint64_t before = cpu->device().texture_bytes();
    AirRig rig(*cpu, {});
    CHECK(rig.air.table_bytes() == cpu->device().texture_bytes() - before);
    const std::uint64_t air_bytes = cpu->device().texture_bytes();
    View view(rig.air);
    CHECK(view.table_bytes() == cpu->device().texture_bytes() - air_bytes);
}

TEST_CASE("atmosphere: refused parameters change nothing") {
    const auto cpu = open_cpu_float();
    AirRig rig(*cpu, {});
    rig.record_air();
    const Image transmittance = rig.transmittance(), multi_scatter = rig.multi_scatter();
    const std::uint64_t created = cpu->device().created;

    AtmosphereParameters bad = smoky();
    bad.planet.ground_albedo.y = 1.5;
    CHECK(detail::rejected_field([&] { rig.air.set_parameters(bad); }) == "planet.ground_albedo.g");
    bad = smoky();
    bad.terms.back().scattering_per_m.z = -1;
    CHECK(mentions(detail::rejected_field([&] { rig.air.set_parameters(bad); }), "scattering_per_m.b"));
    bad = smoky();
    bad.planet.top_radius_m = std::nan("");
    CHECK(detail::rejected_field([&] { rig.air.set_parameters(bad); }) == "planet.top_radius_m");

    CHECK(rig.air.parameters() == presets::earth());
    CHECK(cpu->device().created == created);
    CHECK(rig.record_air().total() == 0);
    CHECK(rig.transmittance() == transmittance);
    CHECK(rig.multi_scatter() == multi_scatter);
}

TEST_CASE("atmosphere: refused settings and parameters leave nothing behind") {
    const auto cpu = open_cpu_float();
    QualitySettings quality = small_quality();
    quality.sky_view_nodes = 99;
    CHECK(detail::rejected_field([&] { Atmosphere air(cpu->device(), presets::earth(), quality); }) ==
          "aureole.sky_view_nodes");
    AtmosphereParameters bad = presets::earth();
    bad.terms[0].profile = ExponentialProfile{-1};
    CHECK(mentions(detail::rejected_field([&] { Atmosphere air(cpu->device(), bad, small_quality()); }), "scale_height_m"));
    CHECK(cpu->device().live() == 0);
}

TEST_CASE("atmosphere: a device that lacks something is told what") {
    const auto cpu = open_cpu_float();
    CountingDevice& device = cpu->device();
    const auto make = [&] { Atmosphere air(device, presets::earth(), small_quality()); };
    rhi::Capabilities less = device.capabilities();
    less.storage_write_without_format = false;
    device.pretend(less);
    CHECK(mentions(failure(make), "unsupported: device.storage_write_without_format"));
    less = cpu->device().capabilities();
    less.storage_write_without_format = true;
    less.max_texture_2d = 1024;  // less than the tables of the user's profiles need
    device.pretend(less);
    CHECK(mentions(failure(make), "unsupported: device.max_texture_2d: 1024"));
    less.max_texture_2d = 16384;
    less.max_texture_3d = 4;
    device.pretend(less);
    CHECK(mentions(failure(make), "unsupported: device.max_texture_3d: 4"));
    device.pretend(std::optional<rhi::Capabilities>());

    const auto lacking = [&](rhi::Format format, rhi::FormatSupport support) {
        device.pretend(std::pair(format, support));
        std::string text = failure(make);
        device.pretend(std::optional<std::pair<rhi::Format, rhi::FormatSupport>>());
        return text;
    };
    const std::string no_storage = lacking(rhi::Format::rgba32_float, {.sampled = true, .linear_filter = true});
    CHECK(mentions(no_storage, "unsupported: "));
    CHECK(mentions(no_storage, "rgba32_float"));
    CHECK(mentions(no_storage, "no storage"));
    CHECK(device.live() == 0);
    CHECK_NOTHROW(make());
}

TEST_CASE("atmosphere: whichever object cannot be made, nothing is left behind") {
    const auto cpu = open_cpu_float();
    CountingDevice& device = cpu->device();
    std::uint64_t failures = 0;
    for (bool made = false; !made; ++failures) {
        device.fail_after(failures);
        const std::string text = failure([&] {
            Atmosphere air(device, smoky(), small_quality());
            View view(air, {}, {.scene_depth = true});
            made = true;
        });
        CHECK(device.live() == 0);
        if (!made) CHECK(mentions(text, "out_of_memory: injected failure"));
    }
    device.fail_after(std::nullopt);
    CHECK(failures > 40);  // as many objects as there are, and the one time it worked
}

TEST_CASE("atmosphere: a change that fails half-way leaves tables, views and prepared composites as they were") {
    const auto cpu = open_cpu_float();
    CountingDevice& device = cpu->device();
    Setup setup;
    setup.composite.target_format = rhi::Format::rgba32_float;
    Rig rig(*cpu, setup);
    View other(rig.air);
    rig.record_air();
    rig.record_view(camera_at(setup.air.planet, 10), sun_at(30));
    const rhi::Extent size{9, 5, 1};
    const CompositeTargets targets{.target = cpu->make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write),
                                   .extent = size};
    rig.view.prepare_composite(targets);
    const auto show = [&] {
        cpu->run([&](rhi::CommandList& commands) { rig.view.record_composite(commands, targets); });
        return cpu->read(targets.target);
    };
    const Image picture = show();
    const std::uint64_t live = device.live();

    std::uint64_t failures = 0;
    for (;; ++failures) {
        device.fail_after(failures);
        const std::string text = failure([&] { rig.air.set_parameters(smoky()); });
        if (text == "nothing") break;
        CHECK(mentions(text, "injected failure"));
        CHECK(device.live() == live);
        CHECK(rig.air.parameters() == setup.air);
        CHECK(rig.record_air().total() == 0);
        CHECK(rig.record_view(camera_at(setup.air.planet, 10), sun_at(30)).total() == 0);
    }
    device.fail_after(std::nullopt);
    CHECK(failures > 50);  // about as many objects as there are
    CHECK(rig.air.parameters() == smoky());
    rig.record_air();
    cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands); });
    CHECK(show() != picture);

    rig.air.set_parameters(setup.air);
    rig.record_air();
    cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands); });
    CHECK(show() == picture);
    CHECK(device.live() == live);
}

TEST_CASE("atmosphere: replaced objects die with the frame that the host has set") {
    const auto cpu = open_cpu_float();
    AirRig rig(*cpu, {});
    rig.record_air();
    rig.air.set_frame(7);
    rig.air.set_parameters(smoky());
    CHECK(cpu->device().last_used_frame == 7);
    rig.air.set_frame(0);
}

TEST_CASE("atmosphere: writes timestamps around each pass, in the slots it was given") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, {});
    const CommandCounts air =
        cpu->run([&](rhi::CommandList& commands) { rig.air.record(commands, {.enabled = true, .first = 0}); });
    CHECK(air.timestamps == 4);
    rig.view.update(camera_at(presets::earth().planet, 2), std::array{sun_at(30)});
    const CommandCounts view =
        cpu->run([&](rhi::CommandList& commands) { rig.view.record(commands, {.enabled = true, .first = 4}); });
    CHECK(view.timestamps == 6);
    std::array<double, 10> times{};
    cpu->device().read_timestamps(times);
    for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] >= times[i - 1]);
}
