// Recording allocates nothing, on any device.
#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/models/bruneton.h>
#include <aureole/presets.h>
#include <doctest/doctest.h>

#include <new>
#include <numbers>
#include <utility>

#include "allocations.h"
#include "passes/dropped_list.h"
#include "passes/rig.h"

#ifdef AUREOLE_TESTS_HAVE_VULKAN
#include <aureole/vulkan/vulkan_device.h>
#endif

using namespace aureole;
using namespace aureole::recording;

namespace {

AtmosphereParameters with_albedo(double albedo) {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(albedo);
    return air;
}

/// Another structure, with tables to upload.
AtmosphereParameters tabulated(double albedo) {
    AtmosphereParameters air = with_albedo(albedo);
    air.terms[1].phase = TabulatedPhase{{0, 0.3, 1.5, std::numbers::pi}, {30, 4, 1, 0.7}};
    air.terms[2].profile = TabulatedProfile{{0, 15e3, 30e3, 60e3}, {0.1, 0.5, 1 + albedo, 0}};
    return air;
}

/// An atmosphere, a view and its target; frames in which something has changed, and in which nothing has.
class Frames {
public:
    Frames(rhi::Device& device, bool raster)
        : device_(device),
          state_(raster ? rhi::State::color_attachment : rhi::State::storage_write),
          air_(device, with_albedo(0), passes::small_quality()),
          view_(air_, {.max_suns = 2, .shadows = {.cascades = raster ? 1u : 0u}},
                {.target_format = rhi::Format::rgba16_float, .raster = raster, .dither = true}) {
        const auto use = raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
        targets_.extent = {24, 16, 1};
        targets_.target =
            device.create_texture({"target", rhi::Dimension::d2, rhi::Format::rgba16_float, targets_.extent, use});
        view_.prepare_composite(targets_);
    }
    ~Frames() { device_.destroy(targets_.target, 0); }
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;

    /// Everything is another one: camera, suns, and the air, by its numbers or by its structure.
    void change(bool structure = false) {
        ++changes_;
        if (structure) tabulated_ = !tabulated_;
        air_.set_parameters(tabulated_ ? tabulated(changes_ * 0.01) : with_albedo(changes_ * 0.01));
        const Sun suns[] = {passes::sun_at(changes_), passes::sun_at(40)};
        view_.update(passes::camera_at(air_.parameters().planet, 100.0 * changes_), suns);
    }
    void spread(int passes) { air_.set_multi_scatter_passes_per_frame(passes); }

    /// Allocations while everything that has changed is recorded; with `dropped`, after the list before has been dropped.
    int record(rhi::CommandList& commands, bool dropped = false) {
        const rhi::TextureBarrier ready{targets_.target, std::exchange(target_state_, state_), state_};
        commands.barrier({&ready, 1}, {});
        begin_counting_allocations();
        if (dropped) air_.invalidate();
        air_.record(commands, {.enabled = true, .first = 0});
        view_.record(commands, {.enabled = true, .first = 4});
        view_.record_composite(commands, targets_, {.enabled = true, .first = 4});
        return end_counting_allocations();
    }
    [[nodiscard]] bool sky_recorded() const { return view_.reports().front().recorded && view_.reports().back().recorded; }
    [[nodiscard]] bool solving() const { return air_.reports()[1].recorded; }

private:
    rhi::Device& device_;
    rhi::State state_, target_state_ = rhi::State::undefined;
    Atmosphere air_;
    View view_;
    CompositeTargets targets_;
    int changes_ = 0;
    bool tabulated_ = false;
};

/// Frames of every kind; `run` records one and gives its allocations.
template <class Run>
void check_frames(Frames& frames, const Run& run) {
    const auto changed = [&](bool structure) {
        frames.change(structure);
        CHECK(run(false) == 0);
        CHECK(frames.sky_recorded());
        CHECK(frames.solving());
    };
    const auto idle = [&] {
        CHECK(run(false) == 0);
        CHECK(!frames.solving());
    };
    for (int repeat = 0; repeat < 3; ++repeat) {
        changed(false);
        idle();
    }
    for (int repeat = 0; repeat < 2; ++repeat) {  // to a structure with tables and back
        changed(true);
        idle();
        changed(false);
        idle();
    }
    frames.spread(1);
    for (int repeat = 0; repeat < 7; ++repeat) changed(false);  // solutions begin, go on, and end
    int rest = 0;
    do {
        CHECK(run(false) == 0);
        ++rest;
    } while (frames.solving() && rest < 20);
    CHECK(rest >= 3);
    CHECK(rest < 20);
    changed(true);  // a structure with tables, whose copy is filled
    changed(false);
    CHECK(run(true) == 0);
    CHECK(frames.sky_recorded());
    idle();
}

/// On a device that runs them. Its own lists grow to their size in the first frames of a kind.
void check_device(rhi::Device& device, rhi::Queue& queue) {
    for (const bool raster : {false, true}) {
        CAPTURE(raster);
        Frames frames(device, raster);
        const auto run = [&](bool dropped) {
            const int allocations = frames.record(queue.begin(), dropped);
            queue.submit();
            queue.wait();
            return allocations;
        };
        for (const bool structure : {false, true, true}) {
            frames.change(structure);
            (void)run(true);
        }
        check_frames(frames, run);
        queue.wait();
    }
}

}  // namespace

TEST_CASE("recording: allocations are counted") {
    begin_counting_allocations();
    ::operator delete(::operator new(4));
    CHECK(end_counting_allocations() == 1);
    constexpr std::align_val_t wide{64};
    begin_counting_allocations();
    ::operator delete(::operator new(4, wide), wide);
    ::operator delete[](::operator new[](100, wide), wide);
    ::operator delete(::operator new(4, wide, std::nothrow), wide);
    ::operator delete[](::operator new[](4));
    CHECK(end_counting_allocations() == 4);
}

TEST_CASE("recording allocates nothing of its own, from the very first frame on") {
    const auto cpu = cpu::create_cpu_device({});
    for (const bool raster : {false, true}) {
        Frames frames(cpu->device(), raster);
        check_frames(frames, [&](bool dropped) {
            passes::DroppedList list;
            return frames.record(list, dropped);
        });
    }
}

TEST_CASE("recording allocates nothing on the CPU device") {
    const auto cpu = cpu::create_cpu_device({});
    check_device(cpu->device(), cpu->queue());
}

#ifdef AUREOLE_TESTS_HAVE_VULKAN
TEST_CASE("recording allocates nothing on the Vulkan device") {
    if (passes::open_vulkan() == nullptr) return;          // it says why
    const auto vulkan = vulkan::create_vulkan_device({});  // without the validation layer, which allocates
    check_device(vulkan->device(), vulkan->queue());
}
#endif

TEST_CASE("a frame's camera, suns, shadow map and exposure allocate nothing either") {
    const auto machine = cpu::create_cpu_device();
    Atmosphere air(machine->device(), presets::earth(), passes::small_quality());
    View view(air, {.max_suns = 2, .shadows = {.cascades = 2}});
    ShadowMap map;
    map.texture =
        machine->device().create_texture({"map", rhi::Dimension::d2, rhi::Format::r32_float, {8, 4, 1}, rhi::Usage::sampled});
    for (int frame = 0; frame < 3; ++frame) {
        const Sun suns[] = {passes::sun_at(10 + frame), passes::sun_at(40)};
        const Camera camera = passes::camera_at(presets::earth().planet, 100.0 + frame);
        map.world_to_map.fill(glm::dmat4(1e-3 * frame));
        begin_counting_allocations();
        air.set_frame(static_cast<std::uint64_t>(frame));
        view.set_shadow_map(map);
        view.update(camera, suns);
        view.set_exposure(1 + frame);
        const int allocations = end_counting_allocations();
        if (frame > 0) CHECK(allocations == 0);  // the first one makes room for suns and map
    }
}

TEST_CASE("recording: bruneton allocates nothing, at once and in parts") {
    const auto cpu = cpu::create_cpu_device({});
    models::BrunetonSettings settings;
    settings.altitude_nodes = 3;
    settings.view_nodes = 6;
    settings.sun_nodes = settings.nu_nodes = 3;
    settings.transmittance = settings.irradiance = {8, 4, 1};
    settings.orders = 3;
    for (const int slices : {0, 2}) {
        CAPTURE(slices);
        settings.slices_per_frame = slices;
        Atmosphere air(cpu->device(), with_albedo(0), models::bruneton(settings));
        for (int frame = 0; frame < 60; ++frame) {
            if (frame % 20 == 9) air.set_parameters(with_albedo(0.01 * frame));
            rhi::CommandList& commands = cpu->queue().begin();
            const bool list_has_grown = frame >= 10;  // to its size in the first solution
            begin_counting_allocations();
            air.record(commands);
            const int allocations = end_counting_allocations();
            if (list_has_grown) CHECK(allocations == 0);
            cpu->queue().submit();
            cpu->queue().wait();
        }
        CHECK(air.progress() == 1);
    }
}
