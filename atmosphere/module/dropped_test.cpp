// Recordings that are never executed: what a host says of them, and that nothing of them is relied on afterwards.
#include <doctest/doctest.h>

#include <numbers>

#include "passes/dropped_list.h"
#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// Earth with profiles and phases from tables, which are uploaded.
AtmosphereParameters tabulated(double albedo) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(albedo);
    air.terms[1].phase = TabulatedPhase{{0, 0.3, 1.5, std::numbers::pi}, {30, 4, 1, 0.7}};
    air.terms[2].profile = TabulatedProfile{{0, 15e3, 30e3, 60e3}, {0.1, 0.5, 1, 0}};
    return air;
}

AtmosphereParameters with_albedo(double albedo) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(albedo);
    return air;
}

const Planet planet = presets::earth().planet;
const Camera high = camera_at(planet, 60e3), low = camera_at(planet, 50);
const Sun sun = sun_at(12);

/// Records all that has changed into a list that is dropped.
void drop(Rig& rig, const Camera& camera) {
    DroppedList list;
    rig.view.update(camera, std::span(&sun, 1));
    rig.air.record(list);
    rig.view.record(list);
    CHECK(list.commands > 0);
}

void check_same(Rig& rig, Rig& wanted) {
    CHECK(rig.transmittance() == wanted.transmittance());
    CHECK(rig.multi_scatter() == wanted.multi_scatter());
    CHECK(rig.sky_view() == wanted.sky_view());
    if (rig.setup.view.aerial_perspective) CHECK(rig.froxels() == wanted.froxels());
    CHECK(rig.light() == wanted.light());
    CHECK(rig.show({19, 11, 1}) == wanted.show({19, 11, 1}));
}

/// Every table of this air, recorded once and executed.
void check_as_new(Rig& rig, const AtmosphereParameters& air, const Camera& camera) {
    CHECK(rig.record_air().total() > 0);
    CHECK(rig.air.reports()[0].recorded);
    CHECK(rig.air.reports()[1].recorded);
    CHECK(rig.record_view(camera, sun).total() > 0);
    CHECK(rig.view.reports()[0].recorded);
    CHECK(rig.view.reports()[2].recorded);
    Setup setup = rig.setup;
    setup.air = air;
    Rig wanted(rig.backend, setup);
    wanted.record_air();
    wanted.record_view(camera, sun);
    check_same(rig, wanted);
    CHECK(rig.record_air().total() + rig.record_view(camera, sun).total() == 0);
}

void check_dropped(Backend& backend, const Setup& setup) {
    Rig rig(backend, setup);
    drop(rig, low);  // the very first recording
    rig.air.invalidate();
    CHECK(backend.run([&](rhi::CommandList& commands) { rig.view.record(commands); }).total() == 0);  // no air to show yet
    check_as_new(rig, setup.air, low);

    AtmosphereParameters air = setup.air;
    air.planet.ground_albedo = Rgb(0.9);
    rig.air.set_parameters(air);
    drop(rig, high);  // while the device holds older tables
    rig.air.invalidate();
    check_as_new(rig, air, high);

    rig.air.invalidate();  // nothing was dropped: all the same
    check_as_new(rig, air, high);
}

}  // namespace

TEST_CASE("dropped recordings: invalidated tables are made anew, whole, on every backend") {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        Setup setup;
        setup.composite.target_format = rhi::Format::rgba32_float;
        setup.composite.scene_depth = false;
        check_dropped(*backend, setup);
        setup.air = tabulated(0.2);
        setup.view.aerial_perspective = false;
        check_dropped(*backend, setup);
        setup.model = model_by_name("hillaire", "low");
        check_dropped(*backend, setup);
    }
}

TEST_CASE("dropped recordings: a solution that is spread over frames is solved at once") {
    const auto cpu = open_cpu_float();
    Setup setup;
    setup.composite.target_format = rhi::Format::rgba32_float;
    Rig rig(*cpu, setup);
    rig.air.set_multi_scatter_passes_per_frame(1);
    rig.record_air();
    rig.record_view(low, sun);
    rig.air.set_parameters(with_albedo(0.9));
    rig.record_air();  // its first pass runs
    drop(rig, low);    // its second does not
    rig.air.invalidate();
    check_as_new(rig, with_albedo(0.9), low);
}

TEST_CASE("dropped recordings: a view's own, and another view's that was executed") {
    const auto cpu = open_cpu_float();
    Setup setup;
    setup.composite.target_format = rhi::Format::rgba32_float;
    Rig rig(*cpu, setup);
    View other(rig.air, setup.view, setup.composite);
    other.update(low, std::span(&sun, 1));
    rig.record_air();
    rig.record_view(low, sun);
    cpu->run([&](rhi::CommandList& commands) { other.record(commands); });

    DroppedList list;
    rig.view.update(high, std::span(&sun, 1));
    rig.view.record(list);
    CHECK(list.commands > 0);
    rig.view.invalidate();
    CHECK(rig.record_air().total() == 0);
    CHECK(cpu->run([&](rhi::CommandList& commands) { other.record(commands); }).total() == 0);
    CHECK(rig.record_view(high, sun).dispatches == 3);
    Rig wanted(*cpu, setup);
    wanted.record_air();
    wanted.record_view(high, sun);
    check_same(rig, wanted);

    rig.air.invalidate();
    rig.record_air();
    CHECK(cpu->run([&](rhi::CommandList& commands) { other.record(commands); }).dispatches == 3);
}
