#include "passes/counting_device.h"

#include <aureole/rhi/checks.h>

namespace aureole::passes {

void CountingList::update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    ++counts.updates;
    inner_.update_constants(buffer, bytes);
}
void CountingList::barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) {
    ++counts.barriers;
    inner_.barrier(textures, buffers);
}
void CountingList::dispatch(const rhi::DispatchDesc& desc) {
    ++counts.dispatches;
    inner_.dispatch(desc);
}
void CountingList::draw_fullscreen(const rhi::DrawDesc& desc) {
    ++counts.draws;
    inner_.draw_fullscreen(desc);
}
void CountingList::copy(const rhi::CopyDesc& desc) {
    ++counts.copies;
    inner_.copy(desc);
}
void CountingList::begin_marker(const char* name) {
    ++counts.markers;
    inner_.begin_marker(name);
}
void CountingList::end_marker() {
    ++counts.markers;
    inner_.end_marker();
}
void CountingList::timestamp(std::uint32_t index) {
    ++counts.timestamps;
    inner_.timestamp(index);
}

void CountingDevice::fail_if_due(const std::string& what) {
    const bool due = fail_at_ == attempts;
    ++attempts;
    if (!due) return;
    fail_at_.reset();
    throw Error(ErrorCode::out_of_memory, "injected failure: " + what);
}

rhi::FormatSupport CountingDevice::format_support(rhi::Format format, rhi::Dimension dimension) const {
    return support_ && support_->first == format ? support_->second : inner_.format_support(format, dimension);
}

rhi::Texture CountingDevice::create_texture(const rhi::TextureDesc& desc) {
    fail_if_due(desc.name);
    rhi::TextureDesc open = desc;
    open.usage = desc.usage | rhi::Usage::copy_source | rhi::Usage::copy_destination;
    const rhi::Texture texture = inner_.create_texture(open);
    textures_.emplace(texture.value, open);
    ++created;
    return texture;
}

rhi::Texture CountingDevice::wrap_texture(const rhi::ExternalTexture& external) {
    fail_if_due(external.desc.name);
    const rhi::Texture texture = inner_.wrap_texture(external);
    textures_.emplace(texture.value, external.desc);
    ++created;
    return texture;
}

rhi::Buffer CountingDevice::create_buffer(const rhi::BufferDesc& desc) {
    fail_if_due(desc.name);
    const rhi::Buffer buffer = inner_.create_buffer(desc);
    ++created;
    return buffer;
}

rhi::Sampler CountingDevice::create_sampler(const rhi::SamplerDesc& desc) {
    fail_if_due("sampler");
    const rhi::Sampler sampler = inner_.create_sampler(desc);
    ++created;
    return sampler;
}

rhi::Pipeline CountingDevice::create_compute_pipeline(const rhi::ComputePipelineDesc& desc) {
    fail_if_due(desc.name);
    const rhi::Pipeline pipeline = inner_.create_compute_pipeline(desc);
    ++created;
    return pipeline;
}

rhi::Pipeline CountingDevice::create_raster_pipeline(const rhi::RasterPipelineDesc& desc) {
    fail_if_due(desc.name);
    const rhi::Pipeline pipeline = inner_.create_raster_pipeline(desc);
    ++created;
    return pipeline;
}

rhi::BindingSet CountingDevice::create_binding_set(const rhi::BindingSetDesc& desc) {
    fail_if_due(desc.name);
    const rhi::BindingSet set = inner_.create_binding_set(desc);
    ++created;
    return set;
}

std::uint64_t CountingDevice::texture_bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& [handle, desc] : textures_) bytes += rhi::packed_size(desc);
    return bytes;
}

void CountingDevice::destroy(rhi::AnyHandle handle, std::uint64_t frame) {
    if (std::visit([](auto h) { return !h; }, handle)) return;
    if (const auto* texture = std::get_if<rhi::Texture>(&handle)) textures_.erase(texture->value);
    ++destroyed;
    last_used_frame = frame;
    inner_.destroy(handle, frame);
}

void CountingDevice::write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    fail_if_due("write_buffer");
    inner_.write_buffer(buffer, bytes);
}

}  // namespace aureole::passes
