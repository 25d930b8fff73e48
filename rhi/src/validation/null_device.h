// For tests: a device that accepts everything, does nothing, and counts what reaches it.
#pragma once

#include <aureole/rhi/device.h>

#include <string>
#include <vector>

namespace aureole::rhi::validation {

class NullCommandList final : public CommandList {
public:
    void update_constants(Buffer, std::span<const std::byte>) override { log.emplace_back("update"); }
    void barrier(std::span<const TextureBarrier>, std::span<const BufferBarrier>) override { log.emplace_back("barrier"); }
    void dispatch(const DispatchDesc&) override { log.emplace_back("dispatch"); }
    void draw_fullscreen(const DrawDesc&) override { log.emplace_back("draw"); }
    void copy(const CopyDesc&) override { log.emplace_back("copy"); }
    void begin_marker(const char* name) override { log.emplace_back(std::string("begin ") + name); }
    void end_marker() override { log.emplace_back("end"); }
    void timestamp(std::uint32_t index) override { log.emplace_back("timestamp " + std::to_string(index)); }

    std::vector<std::string> log;
};

class NullDevice final : public Device {
public:
    NullDevice() {
        capabilities_.max_texture_2d = capabilities_.max_texture_cube = 64;
        capabilities_.max_texture_3d = 16;
        capabilities_.max_push_constant_bytes = 128;
        capabilities_.timestamp_slots = 4;
        capabilities_.raster = true;
    }
    [[nodiscard]] const Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] FormatSupport format_support(Format format, Dimension) const override {
        const bool plain = format != Format::rgba32_float;  // cannot be filtered or drawn to here
        return {true, plain, true, plain};
    }
    [[nodiscard]] Texture create_texture(const TextureDesc&) override { return {++created}; }
    [[nodiscard]] Texture wrap_texture(const ExternalTexture&) override { return {++created}; }
    [[nodiscard]] Buffer create_buffer(const BufferDesc&) override { return {++created}; }
    [[nodiscard]] Sampler create_sampler(const SamplerDesc&) override { return {++created}; }
    [[nodiscard]] Pipeline create_compute_pipeline(const ComputePipelineDesc&) override { return {++created}; }
    [[nodiscard]] Pipeline create_raster_pipeline(const RasterPipelineDesc&) override { return {++created}; }
    [[nodiscard]] BindingSet create_binding_set(const BindingSetDesc&) override { return {++created}; }
    void destroy(AnyHandle, std::uint64_t last_used_frame) override { destroyed_frames.push_back(last_used_frame); }
    void collect(std::uint64_t completed_frame) override { collected_frames.push_back(completed_frame); }
    void write_buffer(Buffer, std::span<const std::byte>) override { ++accesses; }
    void read_buffer(Buffer, std::span<std::byte>) override { ++accesses; }
    void read_timestamps(std::span<double>) override { ++accesses; }
    void set_message_callback(MessageCallback callback, void* user) override { callback_ = callback, user_ = user; }

    void say(Severity severity, const char* text) const {
        if (callback_) callback_(user_, severity, text);
    }
    [[nodiscard]] bool has_callback() const { return callback_ != nullptr; }

    std::uint64_t created = 0;
    int accesses = 0;
    std::vector<std::uint64_t> destroyed_frames, collected_frames;

private:
    Capabilities capabilities_;
    MessageCallback callback_ = nullptr;
    void* user_ = nullptr;
};

class NullQueue final : public Queue {
public:
    [[nodiscard]] CommandList& begin() override { return list; }
    std::uint64_t submit() override { return ++frame; }
    void wait() override {}

    NullCommandList list;
    std::uint64_t frame = 0;
};

}  // namespace aureole::rhi::validation
