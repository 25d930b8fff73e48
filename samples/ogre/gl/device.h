// Creates, finds and destroys the objects of the adapter.
#pragma once

#include "objects.h"

#include <array>
#include <bitset>
#include <unordered_map>

namespace aureole::gl {

inline constexpr std::uint32_t max_timestamps = 256;

/// Objects by handle. What is destroyed is gone at once: OpenGL runs commands in order and keeps what they still read.
template <class Handle, class Object>
class Pool {
public:
    void add(Handle handle, std::shared_ptr<Object> object) { objects_.emplace(handle.value, std::move(object)); }
    [[nodiscard]] std::shared_ptr<Object> share(Handle handle) const {
        const auto found = objects_.find(handle.value);
        return found == objects_.end() ? nullptr : found->second;
    }
    [[nodiscard]] Object* find(Handle handle) const noexcept {
        const auto found = objects_.find(handle.value);
        return found == objects_.end() ? nullptr : found->second.get();
    }
    bool destroy(Handle handle) { return objects_.erase(handle.value) > 0; }

private:
    std::unordered_map<std::uint64_t, std::shared_ptr<Object>> objects_;
};

class Device final : public rhi::Device, public rhi::ObjectLookup {
public:
    Device();
    ~Device() override;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

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
    void collect(std::uint64_t) override {}
    void write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) override;
    void read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) override;
    void read_timestamps(std::span<double> out_nanoseconds) override;
    void set_message_callback(rhi::MessageCallback callback, void* user) override;

    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture texture) const override;
    [[nodiscard]] const rhi::BufferDesc* find(rhi::Buffer buffer) const override;
    [[nodiscard]] const rhi::SamplerDesc* find(rhi::Sampler sampler) const override;

    // For those who record: null if unknown or destroyed.
    [[nodiscard]] TextureObject* object(rhi::Texture texture) const noexcept { return textures_.find(texture); }
    [[nodiscard]] BufferObject* object(rhi::Buffer buffer) const noexcept { return buffers_.find(buffer); }
    [[nodiscard]] PipelineObject* object(rhi::Pipeline pipeline) const noexcept { return pipelines_.find(pipeline); }
    [[nodiscard]] BindingsObject* object(rhi::BindingSet set) const noexcept { return binding_sets_.find(set); }
    [[nodiscard]] GLuint push_buffer() const noexcept { return push_buffer_; }
    [[nodiscard]] GLuint vertex_array() const noexcept { return vertex_array_; }
    void record_timestamp(std::uint32_t index) noexcept;
    void report(rhi::Severity severity, const std::string& text) const noexcept;

private:
    template <class Handle, class Object>
    Handle add(Pool<Handle, Object>& pool, std::shared_ptr<Object> object) {
        const Handle handle{next_handle_++};
        pool.add(handle, std::move(object));
        return handle;
    }
    [[nodiscard]] BindingsObject::Slot fill(const rhi::Shader& shader, const rhi::SlotDesc& slot,
                                            std::span<const rhi::Binding> bindings) const;

    rhi::Capabilities capabilities_;
    std::uint64_t max_block_bytes_ = 0;
    rhi::MessageCallback callback_ = nullptr;
    void* callback_user_ = nullptr;
    std::uint64_t next_handle_ = 1;  // one row for all kinds: a handle of the wrong kind is never found
    Pool<rhi::Texture, TextureObject> textures_;
    Pool<rhi::Buffer, BufferObject> buffers_;
    Pool<rhi::Sampler, SamplerObject> samplers_;
    Pool<rhi::Pipeline, PipelineObject> pipelines_;
    Pool<rhi::BindingSet, BindingsObject> binding_sets_;
    GLuint push_buffer_ = 0, vertex_array_ = 0;
    std::array<GLuint, max_timestamps> queries_{};
    std::bitset<max_timestamps> timed_;
};

}  // namespace aureole::gl
