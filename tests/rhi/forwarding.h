// A device around another that passes everything on: for those that change a little of it.
#pragma once

#include <aureole/rhi/device.h>

namespace aureole::conformance {

class ForwardingDevice : public rhi::Device {
public:
    explicit ForwardingDevice(rhi::Device& inner) : inner_(inner) {}

    [[nodiscard]] const rhi::Capabilities& capabilities() const override { return inner_.capabilities(); }
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override {
        return inner_.format_support(format, dimension);
    }
    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override { return inner_.find(texture); }
    [[nodiscard]] rhi::Texture create_texture(const rhi::TextureDesc& desc) override { return inner_.create_texture(desc); }
    [[nodiscard]] rhi::Texture wrap_texture(const rhi::ExternalTexture& texture) override {
        return inner_.wrap_texture(texture);
    }
    [[nodiscard]] rhi::Buffer create_buffer(const rhi::BufferDesc& desc) override { return inner_.create_buffer(desc); }
    [[nodiscard]] rhi::Sampler create_sampler(const rhi::SamplerDesc& desc) override { return inner_.create_sampler(desc); }
    [[nodiscard]] rhi::Pipeline create_compute_pipeline(const rhi::ComputePipelineDesc& desc) override {
        return inner_.create_compute_pipeline(desc);
    }
    [[nodiscard]] rhi::Pipeline create_raster_pipeline(const rhi::RasterPipelineDesc& desc) override {
        return inner_.create_raster_pipeline(desc);
    }
    [[nodiscard]] rhi::BindingSet create_binding_set(const rhi::BindingSetDesc& desc) override {
        return inner_.create_binding_set(desc);
    }
    void destroy(rhi::AnyHandle handle, std::uint64_t frame) override { inner_.destroy(handle, frame); }
    void collect(std::uint64_t completed_frame) override { inner_.collect(completed_frame); }
    void write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) override { inner_.write_buffer(buffer, bytes); }
    void read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) override { inner_.read_buffer(buffer, bytes); }
    void read_timestamps(std::span<double> out_nanoseconds) override { inner_.read_timestamps(out_nanoseconds); }
    void set_message_callback(rhi::MessageCallback callback, void* user) override {
        inner_.set_message_callback(callback, user);
    }

protected:
    rhi::Device& inner_;
};

}  // namespace aureole::conformance
