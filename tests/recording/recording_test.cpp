// Recording allocates nothing, on any device.
#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/presets.h>
#include <doctest/doctest.h>

#include <array>

#include "allocations.h"
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

/// A frame in which everything has changed, and one in which nothing has.
class Frames {
public:
    Frames(rhi::Device& device, rhi::Queue& queue, bool raster)
        : device_(device),
          queue_(queue),
          state_(raster ? rhi::State::color_attachment : rhi::State::storage_write),
          air_(device, with_albedo(0), passes::small_quality()),
          view_(air_, {.max_suns = 2}, {.target_format = rhi::Format::rgba16_float, .raster = raster, .dither = true}) {
        const auto use = raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
        targets_.extent = {24, 16, 1};
        targets_.target =
            device.create_texture({"target", rhi::Dimension::d2, rhi::Format::rgba16_float, targets_.extent, use});
        view_.prepare_composite(targets_);
    }
    ~Frames() {
        queue_.wait();
        device_.destroy(targets_.target, 0);
    }
    Frames(const Frames&) = delete;
    Frames& operator=(const Frames&) = delete;

    /// Allocations while everything is recorded.
    int record(bool changed) {
        if (changed) {
            air_.set_parameters(with_albedo(++changes_ * 0.01));
            const Sun suns[] = {passes::sun_at(changes_), passes::sun_at(40)};
            view_.update(passes::camera_at(air_.parameters().planet, 100.0 * changes_), suns);
        }
        rhi::CommandList& commands = queue_.begin();
        const rhi::TextureBarrier ready{targets_.target, changes_ == 1 && changed ? rhi::State::undefined : state_, state_};
        commands.barrier({&ready, 1}, {});
        begin_counting_allocations();
        air_.record(commands, {.enabled = true, .first = 0});
        view_.record(commands, {.enabled = true, .first = 4});
        view_.record_composite(commands, targets_, {.enabled = true, .first = 6});
        const int allocations = end_counting_allocations();
        queue_.submit();
        queue_.wait();
        return allocations;
    }
    [[nodiscard]] std::span<const PassReport> reports() const { return view_.reports(); }

private:
    rhi::Device& device_;
    rhi::Queue& queue_;
    rhi::State state_;
    Atmosphere air_;
    View view_;
    CompositeTargets targets_;
    int changes_ = 0;
};

void check_frames(rhi::Device& device, rhi::Queue& queue) {
    for (const bool raster : {false, true}) {
        Frames frames(device, queue, raster);
        (void)frames.record(true);  // a device's lists may grow to their size
        (void)frames.record(true);
        for (int frame = 0; frame < 3; ++frame) {
            CHECK(frames.record(true) == 0);
            CHECK(frames.reports()[0].recorded);
            CHECK(frames.reports()[3].recorded);
            CHECK(frames.record(false) == 0);
            CHECK(!frames.reports()[0].recorded);
            CHECK(frames.reports()[3].recorded);
        }
    }
}

}  // namespace

TEST_CASE("recording: allocations are counted") {
    begin_counting_allocations();
    ::operator delete(::operator new(4));
    CHECK(end_counting_allocations() == 1);
}

TEST_CASE("recording allocates nothing on the CPU device") {
    const auto cpu = cpu::create_cpu_device({});
    check_frames(cpu->device(), cpu->queue());
}

#ifdef AUREOLE_TESTS_HAVE_VULKAN
TEST_CASE("recording allocates nothing on the Vulkan device") {
    if (passes::open_vulkan() == nullptr) return;          // it says why
    const auto vulkan = vulkan::create_vulkan_device({});  // without the validation layer, which allocates
    check_frames(vulkan->device(), vulkan->queue());
}
#endif
