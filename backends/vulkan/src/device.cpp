#include "device.h"

#include "formats.h"
#include "result.h"

#include <algorithm>

namespace aureole::vulkan {
namespace {

/// The largest texture of a kind that may be sampled, in the format that every device has.
std::uint32_t max_side(const Context& context, rhi::Dimension dimension, std::uint32_t limit) {
    const VkImageFormatProperties image = image_limits(context.instance_functions, context.physical.handle,
                                                       rhi::Format::rgba16_float, dimension, VK_IMAGE_USAGE_SAMPLED_BIT);
    return std::min(limit, image.maxExtent.width);
}

rhi::Capabilities capabilities_of(const Context& context, const Timestamps& timestamps) {
    const VkPhysicalDeviceLimits& limits = context.limits();
    rhi::Capabilities c;
    c.backend = "vulkan";
    c.device = context.physical.properties.deviceName;
    c.driver = context.physical.driver;
    c.max_texture_2d = max_side(context, rhi::Dimension::d2, limits.maxImageDimension2D);
    c.max_texture_3d = max_side(context, rhi::Dimension::d3, limits.maxImageDimension3D);
    c.max_texture_cube = max_side(context, rhi::Dimension::cube, limits.maxImageDimensionCube);
    c.max_push_constant_bytes = limits.maxPushConstantsSize;
    c.timestamp_slots = timestamps.slots();
    c.storage_write_without_format = true;  // A device without it is refused.
    c.raster = context.graphics;
    return c;
}

}  // namespace

Device::Device(const ContextDesc& desc, MessageSink& sink)
    : sink_(sink),
      context_(desc),
      timestamps_(context_),
      render_passes_(context_),
      layouts_(context_),
      descriptor_pools_(context_),
      capabilities_(capabilities_of(context_, timestamps_)) {}

rhi::FormatSupport Device::format_support(rhi::Format format, rhi::Dimension dimension) const {
    return vulkan::format_support(context_.instance_functions, context_.physical.handle, context_.graphics, format, dimension);
}

rhi::Texture Device::create_texture(const rhi::TextureDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.format, desc.dimension));
    return objects_.textures.add(std::make_unique<TextureObject>(context_, render_passes_, desc));
}

rhi::Texture Device::wrap_texture(const rhi::ExternalTexture& external) {
    rhi::check(external, capabilities_, format_support(external.desc.format, external.desc.dimension));
    return objects_.textures.add(std::make_unique<TextureObject>(context_, render_passes_, external));
}

rhi::Buffer Device::create_buffer(const rhi::BufferDesc& desc) {
    rhi::check(desc);
    return objects_.buffers.add(std::make_unique<BufferObject>(context_, desc));
}

rhi::Sampler Device::create_sampler(const rhi::SamplerDesc& desc) {
    rhi::check(desc);
    return objects_.samplers.add(std::make_unique<SamplerObject>(context_, desc));
}

rhi::Pipeline Device::create_compute_pipeline(const rhi::ComputePipelineDesc& desc) {
    rhi::check(desc, capabilities_);
    return objects_.pipelines.add(std::make_unique<PipelineObject>(context_, layouts_, desc));
}

rhi::Pipeline Device::create_raster_pipeline(const rhi::RasterPipelineDesc& desc) {
    rhi::check(desc, capabilities_, format_support(desc.target_format, rhi::Dimension::d2));
    return objects_.pipelines.add(std::make_unique<PipelineObject>(context_, layouts_, render_passes_, desc));
}

rhi::BindingSet Device::create_binding_set(const rhi::BindingSetDesc& desc) {
    const PipelineObject* pipeline = objects_.pipelines.find(desc.pipeline);
    if (!pipeline)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("binding set", desc.name, "pipeline"),
                    desc.pipeline ? "an unknown or destroyed pipeline" : "null", "a live pipeline");
    rhi::check(desc, pipeline->shader(), objects_, *this);
    std::vector<NativeBinding> bindings;
    for (const rhi::SlotDesc& slot : pipeline->shader().slots) {
        const auto fits = [&](const rhi::Binding& b) { return b.slot == slot.slot; };
        bindings.push_back(native_binding(slot, *std::find_if(desc.bindings.begin(), desc.bindings.end(), fits)));
    }
    return objects_.binding_sets.add(
        std::make_unique<BindingSetObject>(context_, descriptor_pools_, desc.name, *pipeline, bindings));
}

NativeBinding Device::native_binding(const rhi::SlotDesc& slot, const rhi::Binding& binding) const {
    NativeBinding native;
    native.slot = slot.slot;
    native.kind = slot.kind;
    if (slot.kind == rhi::SlotKind::constants) {
        native.buffer = {objects_.buffers.find(binding.buffer)->buffer(), 0, VK_WHOLE_SIZE};
        return native;
    }
    const TextureObject& texture = *objects_.textures.find(binding.texture);
    if (slot.kind == rhi::SlotKind::storage_texture)
        native.image = {VK_NULL_HANDLE, texture.storage_view(), VK_IMAGE_LAYOUT_GENERAL};
    else
        native.image = {objects_.samplers.find(binding.sampler)->sampler(), texture.sampled_view(), texture.read_layout()};
    return native;
}

namespace {
/// The object of a handle that the caller gave.
template <class Registry, class Handle>
const auto& live(const Registry& registry, Handle handle, const char* kind) {
    const auto* object = registry.find(handle);
    if (!object)
        throw Error(ErrorCode::invalid_argument, kind, handle ? "an unknown or destroyed handle" : "null",
                    std::string("a live ") + kind + " of this device");
    return *object;
}
}  // namespace

NativeTexture Device::native(rhi::Texture texture) const {
    const TextureObject& object = live(objects_.textures, texture, "texture");
    return {object.image(), object.sampled_view(), object.read_layout()};
}

VkBuffer Device::native(rhi::Buffer buffer) const { return live(objects_.buffers, buffer, "buffer").buffer(); }

void Device::destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame) {
    if (!objects_.destroy(handle, last_used_frame)) sink_.misuse("destroy: unknown or destroyed handle");
}

void Device::collect(std::uint64_t completed_frame) { objects_.collect(completed_frame); }

void Device::write_buffer(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    BufferObject* object = objects_.buffers.find(buffer);
    if (!object) throw Error(ErrorCode::misuse, "write_buffer: unknown or destroyed buffer");
    object->write(bytes);
}

void Device::read_buffer(rhi::Buffer buffer, std::span<std::byte> bytes) {
    const BufferObject* object = objects_.buffers.find(buffer);
    if (!object) throw Error(ErrorCode::misuse, "read_buffer: unknown or destroyed buffer");
    object->read(bytes);
}

void Device::read_timestamps(std::span<double> out_nanoseconds) { timestamps_.read(out_nanoseconds); }

void Device::set_message_callback(rhi::MessageCallback callback, void* user) { sink_.set(callback, user); }

}  // namespace aureole::vulkan
