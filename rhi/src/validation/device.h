// The validation device: knows every object, and hands out the watching command list.
#pragma once

#include <aureole/rhi/validation.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "command_list.h"
#include "records.h"
#include "reporter.h"

namespace aureole::rhi::validation {

class WatchingDevice final : public ValidationDevice, public ObjectLookup {
public:
    WatchingDevice(Device& inner, const ValidationDesc& desc);
    ~WatchingDevice() override;

    [[nodiscard]] const Capabilities& capabilities() const override { return inner_.capabilities(); }
    [[nodiscard]] FormatSupport format_support(Format format, Dimension dimension) const override;
    [[nodiscard]] Texture create_texture(const TextureDesc& desc) override;
    [[nodiscard]] Texture wrap_texture(const ExternalTexture& external) override;
    [[nodiscard]] Buffer create_buffer(const BufferDesc& desc) override;
    [[nodiscard]] Sampler create_sampler(const SamplerDesc& desc) override;
    [[nodiscard]] Pipeline create_compute_pipeline(const ComputePipelineDesc& desc) override;
    [[nodiscard]] Pipeline create_raster_pipeline(const RasterPipelineDesc& desc) override;
    [[nodiscard]] BindingSet create_binding_set(const BindingSetDesc& desc) override;
    void destroy(AnyHandle handle, std::uint64_t last_used_frame) override;
    void collect(std::uint64_t completed_frame) override;
    void write_buffer(Buffer buffer, std::span<const std::byte> bytes) override;
    void read_buffer(Buffer buffer, std::span<std::byte> bytes) override;
    void read_timestamps(std::span<double> out_nanoseconds) override;
    void set_message_callback(MessageCallback callback, void* user) override { reporter_.set_callback(callback, user); }

    CommandList& begin_list(CommandList& inner, std::uint64_t frame) override;
    void end_list() override;
    [[nodiscard]] std::uint64_t misuse_count() const override { return reporter_.count(); }

    // For the queue, which counts the frames if there is one.
    void count_submitted(std::optional<std::uint64_t> frame) { submitted_frame_ = frame; }
    /// All work up to this frame has finished.
    void complete(std::uint64_t frame);
    [[nodiscard]] bool list_open() const { return list_.open(); }

    // For the command list.
    [[nodiscard]] Reporter& reporter() { return reporter_; }
    [[nodiscard]] const TextureDesc* find(Texture texture) const override;
    [[nodiscard]] const BufferDesc* find(Buffer buffer) const override;
    [[nodiscard]] const SamplerDesc* find(Sampler sampler) const override;
    /// The record, noted as used by the frame that is being recorded; null, and a report, if it is not alive.
    template <class Handle>
    auto* recorded(Handle handle, const char* function);
    void note_timestamp(std::uint32_t index) { timestamp_frames_[index] = recording_frame_; }

    Records<Texture, TextureRecord> textures;
    Records<Buffer, BufferRecord> buffers;
    Records<Sampler, SamplerRecord> samplers;
    Records<Pipeline, PipelineRecord> pipelines;
    Records<BindingSet, BindingSetRecord> binding_sets;

private:
    auto& records(Texture) { return textures; }
    auto& records(Buffer) { return buffers; }
    auto& records(Sampler) { return samplers; }
    auto& records(Pipeline) { return pipelines; }
    auto& records(BindingSet) { return binding_sets; }

    /// Runs the checks and the creation; reports what they throw, and throws it on.
    template <class Make>
    auto created(const Make& make);
    template <class Handle>
    void destroy_one(Handle handle, std::uint64_t last_used_frame);
    /// What is wrong if the list ends with the texture as it is now; empty if nothing.
    [[nodiscard]] static std::string complain_left(const TextureRecord& texture, const char* when);
    void check_cpu_access(Buffer buffer, const char* function, Usage usage, std::size_t bytes);

    Device& inner_;
    Reporter reporter_;
    WatchingCommandList list_;
    std::vector<std::uint64_t> timestamp_frames_;  // the frame that writes each slot; 0: none yet
    std::uint64_t recording_frame_ = 0;            // of the latest list
    std::uint64_t completed_frame_ = 0;
    std::optional<std::uint64_t> submitted_frame_;  // where a queue counts them
};

template <class Handle>
auto* WatchingDevice::recorded(Handle handle, const char* function) {
    auto* record = records(handle).find(handle);
    if (record)
        record->last_frame = recording_frame_;
    else
        reporter_.misuse(std::string(function) + ": " + records(handle).explain(handle));
    return record;
}

}  // namespace aureole::rhi::validation
