// rhi::Device on a VkDevice, own or borrowed.
#pragma once

#include "context.h"
#include "messages.h"
#include "objects.h"
#include "timestamps.h"

#include <aureole/rhi/device.h>
#include <aureole/vulkan/vulkan_device.h>

namespace aureole::vulkan {

class Device final : public rhi::Device {
public:
    /// `sink` outlives the device. Throws Error and leaves nothing behind.
    Device(const ContextDesc& desc, MessageSink& sink);

    [[nodiscard]] const rhi::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override;

    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override { return objects_.find(texture); }

    [[nodiscard]] rhi::Texture create_texture(const rhi::TextureDesc& desc) override;
    [[nodiscard]] rhi::Texture wrap_texture(const rhi::ExternalTexture& external) override;
    [[nodiscard]] rhi::Buffer create_buffer(const rhi::BufferDesc& desc) override;
    [[nodiscard]] rhi::Sampler create_sampler(const rhi::SamplerDesc& desc) override;
    [[nodiscard]] rhi::Pipeline create_compute_pipeline(const rhi::ComputePipelineDesc& desc) override;
    [[nodiscard]] rhi::Pipeline create_raster_pipeline(const rhi::RasterPipelineDesc& desc) override;
    [[nodiscard]] rhi::BindingSet create_binding_set(const rhi::BindingSetDesc& desc) override;

    void destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame) override;
    void collect(std::uint64_t completed_frame) override;
    void write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) override;
    void read_timestamps(std::span<double> out_nanoseconds) override;
    void set_message_callback(rhi::MessageCallback callback, void* user) override;

    /// Throw Error(invalid_argument) for null, unknown and destroyed handles.
    [[nodiscard]] NativeTexture native(rhi::Texture texture) const;
    [[nodiscard]] VkBuffer native(rhi::Buffer buffer) const;

    [[nodiscard]] Context& context() noexcept { return context_; }
    [[nodiscard]] Objects& objects() noexcept { return objects_; }
    [[nodiscard]] Timestamps& timestamps() noexcept { return timestamps_; }
    [[nodiscard]] const MessageSink& sink() const noexcept { return sink_; }

private:
    [[nodiscard]] NativeBinding native_binding(const rhi::SlotDesc& slot, const rhi::Binding& binding) const;

    // Destroyed from the last to the first.
    MessageSink& sink_;
    Context context_;
    Timestamps timestamps_;
    RenderPasses render_passes_;
    ShaderLayouts layouts_;
    DescriptorPools descriptor_pools_;
    Objects objects_;
    rhi::Capabilities capabilities_;
};

}  // namespace aureole::vulkan
