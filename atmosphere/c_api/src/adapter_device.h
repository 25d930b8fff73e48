// rhi::Device and rhi::CommandList over a table of C callbacks.
#pragma once

#include <aureole/c/adapter.h>
#include <aureole/rhi/checks.h>
#include <aureole/rhi/device.h>

#include <memory>
#include <string>
#include <unordered_map>

namespace aureole::c_api {

/// Null for a handle that nothing lives by.
template <class Records>
[[nodiscard]] const auto* record_of(const Records& records, std::uint64_t handle) {
    const auto found = records.find(handle);
    return found == records.end() ? nullptr : &found->second;
}

/// Checks what callbacks need not: descriptors when objects are made, commands when they are recorded. For that it remembers
/// what lives.
class AdapterDevice final : public rhi::Device, private rhi::ObjectLookup {
public:
    /// Throws Error(invalid_argument) naming a callback that is missing.
    explicit AdapterDevice(const aureole_adapter& adapter);
    ~AdapterDevice() override;
    AdapterDevice(const AdapterDevice&) = delete;
    AdapterDevice& operator=(const AdapterDevice&) = delete;

    /// What records into the host's list, until the next call.
    [[nodiscard]] rhi::CommandList& list(void* host_list);

    [[nodiscard]] const rhi::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) const override;
    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override;
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

private:
    class List;
    struct PipelineRecord {
        std::string name;
        const rhi::Shader* shader;
        rhi::Format target_format;
    };
    struct SetRecord {
        std::string name;
        const rhi::Shader* shader;
    };
    [[nodiscard]] const rhi::BufferDesc* find(rhi::Buffer buffer) const override;
    [[nodiscard]] const rhi::SamplerDesc* find(rhi::Sampler sampler) const override;
    [[nodiscard]] rhi::Pipeline add_pipeline(PipelineRecord record, std::span<const rhi::Specialization> specialization,
                                             aureole_result (*create)(void*, const aureole_pipeline_desc*, std::uint64_t*),
                                             const char* function);
    const rhi::BufferDesc& usable(rhi::Buffer buffer, rhi::Usage usage, std::size_t bytes, const char* function) const;
    void tell(const std::string& text) const noexcept;

    const aureole_adapter c_;
    rhi::Capabilities capabilities_;
    std::unordered_map<std::uint64_t, rhi::TextureDesc> textures_;
    std::unordered_map<std::uint64_t, rhi::BufferDesc> buffers_;
    std::unordered_map<std::uint64_t, rhi::SamplerDesc> samplers_;
    std::unordered_map<std::uint64_t, PipelineRecord> pipelines_;
    std::unordered_map<std::uint64_t, SetRecord> sets_;
    std::unique_ptr<List> list_;
    rhi::MessageCallback callback_ = nullptr;
    void* callback_user_ = nullptr;
};

/// The same shader in C, at an address that stays.
[[nodiscard]] const aureole_shader& shader_in_c(const rhi::Shader& shader);
/// Where it came from.
[[nodiscard]] const rhi::Shader& shader_of(const aureole_shader& shader);

}  // namespace aureole::c_api
