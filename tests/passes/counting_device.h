// A device around any other that counts objects and commands, fails when told to, and lets tests read and write every texture.
#pragma once

#include <aureole/rhi/device.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace aureole::passes {

/// Commands recorded through a CountingList.
struct CommandCounts {
    std::uint64_t updates = 0, barriers = 0, dispatches = 0, draws = 0, copies = 0, markers = 0, timestamps = 0;
    [[nodiscard]] std::uint64_t total() const noexcept {
        return updates + barriers + dispatches + draws + copies + markers + timestamps;
    }
};

class CountingList final : public rhi::CommandList {
public:
    explicit CountingList(rhi::CommandList& inner) : inner_(inner) {}

    void update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) override;
    void dispatch(const rhi::DispatchDesc& desc) override;
    void draw_fullscreen(const rhi::DrawDesc& desc) override;
    void copy(const rhi::CopyDesc& desc) override;
    void begin_marker(const char* name) override;
    void end_marker() override;
    void timestamp(std::uint32_t index) override;

    CommandCounts counts;

private:
    rhi::CommandList& inner_;
};

class CountingDevice final : public rhi::Device {
public:
    explicit CountingDevice(rhi::Device& inner) : inner_(inner) {}

    /// The creation (or upload) after `more` further ones throws Error(out_of_memory), once. Nullopt: none.
    void fail_after(std::optional<std::uint64_t> more) { fail_at_ = more ? std::optional(attempts + *more) : std::nullopt; }
    [[nodiscard]] std::uint64_t live() const { return created - destroyed; }
    /// Of a texture made through this device and not destroyed yet.
    [[nodiscard]] const rhi::TextureDesc& desc(rhi::Texture texture) const { return textures_.at(texture.value); }

    /// Memory of the live textures made through this device, bytes.
    [[nodiscard]] std::uint64_t texture_bytes() const;
    /// Answers instead of the inner device's, where given.
    void pretend(std::optional<rhi::Capabilities> capabilities) { capabilities_ = std::move(capabilities); }
    void pretend(std::optional<std::pair<rhi::Format, rhi::FormatSupport>> support) { support_ = support; }

    std::uint64_t attempts = 0, created = 0, destroyed = 0;
    std::uint64_t last_used_frame = 0;  ///< Of the object destroyed last.

    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override { return inner_.find(texture); }
    [[nodiscard]] const rhi::Capabilities& capabilities() const override {
        return capabilities_ ? *capabilities_ : inner_.capabilities();
    }
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override;
    /// Textures may also be copied from and to.
    [[nodiscard]] rhi::Texture create_texture(const rhi::TextureDesc& desc) override;
    [[nodiscard]] rhi::Texture wrap_texture(const rhi::ExternalTexture& external) override;
    [[nodiscard]] rhi::Buffer create_buffer(const rhi::BufferDesc& desc) override;
    [[nodiscard]] rhi::Sampler create_sampler(const rhi::SamplerDesc& desc) override;
    [[nodiscard]] rhi::Pipeline create_compute_pipeline(const rhi::ComputePipelineDesc& desc) override;
    [[nodiscard]] rhi::Pipeline create_raster_pipeline(const rhi::RasterPipelineDesc& desc) override;
    [[nodiscard]] rhi::BindingSet create_binding_set(const rhi::BindingSetDesc& desc) override;
    void destroy(rhi::AnyHandle handle, std::uint64_t frame) override;
    void collect(std::uint64_t completed_frame) override { inner_.collect(completed_frame); }
    void write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) override { inner_.read_buffer(buffer, bytes); }
    void read_timestamps(std::span<double> out_nanoseconds) override { inner_.read_timestamps(out_nanoseconds); }
    void set_message_callback(rhi::MessageCallback callback, void* user) override {
        inner_.set_message_callback(callback, user);
    }

private:
    void fail_if_due(const std::string& what);

    rhi::Device& inner_;
    std::optional<std::uint64_t> fail_at_;
    std::map<std::uint64_t, rhi::TextureDesc> textures_;
    std::optional<rhi::Capabilities> capabilities_;
    std::optional<std::pair<rhi::Format, rhi::FormatSupport>> support_;
};

}  // namespace aureole::passes
