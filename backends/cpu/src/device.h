// Creates, finds and destroys the objects of the CPU backend.
#pragma once

#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi/checks.h>
#include <aureole/rhi/device.h>

#include <map>
#include <string>
#include <vector>

#include "bindings.h"
#include "buffer.h"
#include "pipeline.h"
#include "pool.h"
#include "texture.h"
#include "workers.h"

namespace aureole::cpu {

inline constexpr std::uint32_t timestamp_slots = 1024;

class CpuRhiDevice final : public rhi::Device, public rhi::ObjectLookup {
public:
    explicit CpuRhiDevice(const CpuDeviceDesc& desc);

    [[nodiscard]] const rhi::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override;
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

    // For those who record: null if unknown or destroyed.
    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override;
    [[nodiscard]] const rhi::BufferDesc* find(rhi::Buffer buffer) const override;
    [[nodiscard]] const rhi::SamplerDesc* find(rhi::Sampler sampler) const override;
    [[nodiscard]] const auto& textures() const noexcept { return textures_; }
    [[nodiscard]] const auto& buffers() const noexcept { return buffers_; }
    [[nodiscard]] const auto& pipelines() const noexcept { return pipelines_; }
    [[nodiscard]] const auto& binding_sets() const noexcept { return binding_sets_; }

    void report(rhi::Severity severity, const std::string& text) const noexcept;
    void set_timestamp(std::uint32_t index, double nanoseconds) { timestamps_[index] = nanoseconds; }
    [[nodiscard]] Workers& workers() noexcept { return workers_; }
    [[nodiscard]] const Workers& workers() const noexcept { return workers_; }
    [[nodiscard]] Precision precision() const noexcept { return precision_; }
    [[nodiscard]] std::vector<PipelineWork> work() const;
    void reset_work();

private:
    template <class Handle, class Object>
    Handle add(Pool<Handle, Object>& pool, std::shared_ptr<Object> object);
    PipelineWork* work_of(const std::string& pipeline);

    Precision precision_;
    bool count_work_;
    Workers workers_;
    rhi::Capabilities capabilities_;
    rhi::MessageCallback callback_ = nullptr;
    void* callback_user_ = nullptr;
    std::uint64_t next_handle_ = 1;  // one row for all kinds: a handle of the wrong kind is never found
    Pool<rhi::Texture, TextureObject> textures_;
    Pool<rhi::Buffer, BufferObject> buffers_;
    Pool<rhi::Sampler, rhi::SamplerDesc> samplers_;
    Pool<rhi::Pipeline, PipelineObject> pipelines_;
    Pool<rhi::BindingSet, BindingsObject> binding_sets_;
    std::vector<double> timestamps_;
    std::map<std::string, PipelineWork> work_;
};

}  // namespace aureole::cpu
