// The kit finds what is wrong with a device: the CPU device with one fault each, as adapters have had them.
#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "rhi/forwarding.h"

using namespace aureole;
using namespace aureole::rhi;

namespace {

enum class Fault {
    none,
    constants_unspecialized,
    sampler_repeats,
    sampler_nearest,
    push_constants_lost,
    update_lost,
    last_group_missing,
    draws_lost,
    timestamps_stand_still,
    bad_textures_accepted,
    errors_without_names,
    wrong_dispatch_unsaid,
    tables_dimmed,
    everything_throws,
};

/// Commands with the fault.
class FaultyList final : public CommandList {
public:
    FaultyList(CommandList& inner, Fault fault) : inner_(inner), fault_(fault) {}
    void update_constants(Buffer buffer, std::span<const std::byte> bytes) override {
        if (fault_ != Fault::update_lost || ++updates_ == 1) inner_.update_constants(buffer, bytes);
    }
    void barrier(std::span<const TextureBarrier> textures, std::span<const BufferBarrier> buffers) override {
        inner_.barrier(textures, buffers);
    }
    void dispatch(const DispatchDesc& desc) override {
        DispatchDesc changed = desc;
        const std::vector<std::byte> zeros(desc.push_constants.size());
        if (fault_ == Fault::push_constants_lost) changed.push_constants = zeros;
        if (fault_ == Fault::last_group_missing && changed.groups[0] > 1) --changed.groups[0];
        inner_.dispatch(changed);
    }
    void draw_fullscreen(const DrawDesc& desc) override {
        if (fault_ != Fault::draws_lost) inner_.draw_fullscreen(desc);
    }
    void copy(const CopyDesc& desc) override { inner_.copy(desc); }
    void begin_marker(const char* name) override { inner_.begin_marker(name); }
    void end_marker() override { inner_.end_marker(); }
    void timestamp(std::uint32_t index) override { inner_.timestamp(index); }

private:
    CommandList& inner_;
    Fault fault_;
    int updates_ = 0;
};

class FaultyDevice final : public conformance::ForwardingDevice {
public:
    FaultyDevice(Device& inner, Fault fault) : ForwardingDevice(inner), fault_(fault) {}
    [[nodiscard]] Texture create_texture(const TextureDesc& desc) override {
        TextureDesc changed = desc;
        if (fault_ == Fault::bad_textures_accepted) changed.extent.width = std::max(desc.extent.width, 1u);
        if (fault_ == Fault::errors_without_names) changed.name = "texture 1";
        if (fault_ == Fault::everything_throws) throw 42;
        return inner_.create_texture(changed);
    }
    [[nodiscard]] Sampler create_sampler(const SamplerDesc& desc) override {
        SamplerDesc changed = desc;
        if (fault_ == Fault::sampler_repeats) changed.address_u = changed.address_v = Address::repeat;
        if (fault_ == Fault::sampler_nearest) changed.filter = Filter::nearest;
        return inner_.create_sampler(changed);
    }
    [[nodiscard]] Pipeline create_compute_pipeline(const ComputePipelineDesc& desc) override {
        ComputePipelineDesc changed = desc;
        if (fault_ == Fault::constants_unspecialized) changed.specialization = {};
        return inner_.create_compute_pipeline(changed);
    }
    void read_buffer(Buffer buffer, std::span<std::byte> bytes) override {
        inner_.read_buffer(buffer, bytes);
        // Of floats: one step of eight bits, as a table in a smaller format would have it.
        if (fault_ == Fault::tables_dimmed && bytes.size() > 1000)
            for (std::size_t i = 2; i < bytes.size(); i += 4) bytes[i] &= std::byte{0xc0};
    }
    void read_timestamps(std::span<double> out_nanoseconds) override {
        if (fault_ != Fault::timestamps_stand_still) return inner_.read_timestamps(out_nanoseconds);
        std::fill(out_nanoseconds.begin(), out_nanoseconds.end(), 1);
    }
    void set_message_callback(MessageCallback callback, void* user) override {
        if (fault_ != Fault::wrong_dispatch_unsaid) inner_.set_message_callback(callback, user);
    }

private:
    Fault fault_;
};

class FaultyQueue final : public Queue {
public:
    FaultyQueue(Queue& inner, Fault fault) : inner_(inner), fault_(fault) {}
    [[nodiscard]] CommandList& begin() override {
        list_ = std::make_unique<FaultyList>(inner_.begin(), fault_);
        return *list_;
    }
    std::uint64_t submit() override { return inner_.submit(); }
    void wait() override { inner_.wait(); }

private:
    Queue& inner_;
    Fault fault_;
    std::unique_ptr<FaultyList> list_;
};

/// Names of the checks that fail.
std::vector<std::string> failed_with(Fault fault, std::initializer_list<const char*> names) {
    const auto cpu = cpu::create_cpu_device({});
    FaultyDevice device(cpu->device(), fault);
    FaultyQueue queue(cpu->queue(), fault);
    std::vector<std::string> failed;
    for (const char* name : names) {
        const conformance::Result result = conformance::check_by_name(name).run({device, queue, true});
        if (result.outcome != conformance::Outcome::failed) continue;
        failed.emplace_back(name);
        CAPTURE(result.text());
        CHECK(!result.failures.empty());
        CHECK(result.failures.size() <= 13);
    }
    return failed;
}

}  // namespace

TEST_CASE("each fault of a device fails the check that is about it, and no check that is not") {
    using Names = std::vector<std::string>;
    CHECK(failed_with(Fault::none, {"specialization", "constants", "pass: sky-view"}) == Names{});
    CHECK(failed_with(Fault::constants_unspecialized, {"specialization", "constants"}) == Names{"specialization"});
    CHECK(failed_with(Fault::sampler_repeats, {"nearest filter", "linear filter", "linear filter, repeat"}) ==
          Names{"nearest filter", "linear filter"});
    CHECK(failed_with(Fault::sampler_nearest, {"nearest filter", "linear filter", "3d textures", "edges of cubes"}) ==
          Names{"linear filter", "3d textures", "edges of cubes"});
    CHECK(failed_with(Fault::push_constants_lost, {"constants", "barriers", "specialization"}) ==
          Names{"constants", "barriers"});
    CHECK(failed_with(Fault::update_lost, {"order of updates", "constants"}) == Names{"order of updates"});
    CHECK(failed_with(Fault::last_group_missing, {"barriers", "storage formats", "raster"}) ==
          Names{"barriers", "storage formats"});
    CHECK(failed_with(Fault::draws_lost, {"raster", "attachment formats", "barriers", "raster and barriers"}) ==
          Names{"raster", "attachment formats", "raster and barriers"});
    CHECK(failed_with(Fault::timestamps_stand_still, {"timestamps", "frames"}) == Names{"timestamps"});
    CHECK(failed_with(Fault::bad_textures_accepted, {"creation errors"}) == Names{"creation errors"});
    CHECK(failed_with(Fault::errors_without_names, {"creation errors"}) == Names{"creation errors"});
    CHECK(failed_with(Fault::wrong_dispatch_unsaid, {"markers and messages"}) == Names{"markers and messages"});
    CHECK(failed_with(Fault::everything_throws, {"texel round trips", "frames"}) == Names{"texel round trips", "frames"});
}

TEST_CASE("tables that are wrong by more than the tolerance fail the passes" * doctest::test_suite("long")) {
    using Names = std::vector<std::string>;
    // Nearest in place of linear look-ups: where a pass reads a table at its nodes alone, nothing changes.
    CHECK(failed_with(Fault::sampler_nearest, {"pass: transmittance", "pass: multi-scatter", "pass: sky-view", "pass: light",
                                               "pass: aerial perspective", "pass: composite"}) ==
          Names{"pass: multi-scatter", "pass: sky-view", "pass: light", "pass: aerial perspective", "pass: composite"});
    CHECK(failed_with(Fault::tables_dimmed, {"pass: transmittance", "pass: sky-view", "pass: aerial perspective"}) ==
          Names{"pass: transmittance", "pass: sky-view", "pass: aerial perspective"});
    CHECK(failed_with(Fault::draws_lost, {"pass: composite, drawn", "pass: composite"}) == Names{"pass: composite, drawn"});
    CHECK(failed_with(Fault::everything_throws, {"pass: light"}) == Names{"pass: light"});
}
