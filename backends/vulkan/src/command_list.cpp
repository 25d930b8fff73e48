#include "command_list.h"

#include "barriers.h"

#include <optional>
#include <string>

namespace aureole::vulkan {
namespace {

/// Facts about an object that may not exist, as rhi::complaint wants them.
template <class Object>
struct Facts {
    std::optional<decltype(std::declval<const Object>().facts())> value;
    [[nodiscard]] auto get() const noexcept { return value ? &*value : nullptr; }
};
template <class Object>
Facts<Object> facts_of(const Object* object) {
    return object ? Facts<Object>{object->facts()} : Facts<Object>{};
}

std::string too_high(const char* field, std::uint32_t value, std::uint32_t limit) {
    return std::string(field) + ": " + std::to_string(value) + " is not allowed; allowed: below " + std::to_string(limit);
}

}  // namespace

CommandList::CommandList(Device& device) : device_(device), context_(device.context()), fn_(device.context().fn) {}

void CommandList::begin(VkCommandBuffer commands, std::uint32_t queue_family) noexcept {
    commands_ = commands;
    graphics_ = context_.physical.has_graphics(queue_family);
    timestamps_ = context_.physical.queue_families[queue_family].timestampValidBits > 0;
    open_markers_ = 0;
    device_.objects().for_each_texture([](TextureObject& texture) { texture.start_recording(); });
}

void CommandList::end() noexcept {
    if (!commands_) return;
    {
        BarrierBatch batch(context_, commands_, graphics_);
        // Also those that were destroyed meanwhile: the host's image lives on.
        device_.objects().for_each_texture([&](TextureObject& texture) {
            if (texture.is_lent() && texture.last_state != texture.lent_state())
                batch.add(texture, texture.last_state, texture.lent_state());
        });
    }
    while (open_markers_ > 0) end_marker();
    commands_ = VK_NULL_HANDLE;
}

/// True if nothing speaks against recording the command; else says what does.
bool CommandList::allowed(const char* verb, const std::string& complaint) const noexcept {
    if (!commands_)
        device_.sink().misuse(std::string(verb) + ": the command list is not recording");
    else if (!complaint.empty())
        device_.sink().misuse(complaint);
    return commands_ && complaint.empty();
}

void CommandList::update_constants(rhi::Buffer buffer, std::span<const std::byte> bytes) {
    const BufferObject* object = device_.objects().buffers.find(buffer);
    if (!allowed("update_constants", rhi::complaint(object ? &object->desc() : nullptr, bytes))) return;
    fn_.vkCmdUpdateBuffer(commands_, object->buffer(), 0, bytes.size(), bytes.data());
}

void CommandList::barrier(std::span<const rhi::TextureBarrier> textures, std::span<const rhi::BufferBarrier> buffers) {
    if (!allowed("barrier")) return;
    BarrierBatch batch(context_, commands_, graphics_);
    for (const rhi::TextureBarrier& entry : textures) {
        TextureObject* texture = device_.objects().textures.find(entry.texture);
        if (texture)
            batch.add(*texture, entry.before, entry.after);
        else
            device_.sink().misuse("barrier: unknown or destroyed texture");
    }
    for (const rhi::BufferBarrier& entry : buffers) {
        BufferObject* buffer = device_.objects().buffers.find(entry.buffer);
        if (buffer)
            batch.add(*buffer, entry.before, entry.after);
        else
            device_.sink().misuse("barrier: unknown or destroyed buffer");
    }
}

/// What compute and raster work have in common.
void CommandList::bind(VkPipelineBindPoint point, const PipelineObject& pipeline, const BindingSetObject* bindings,
                       std::span<const std::byte> push_constants) noexcept {
    const ShaderLayout& layout = pipeline.layout();
    fn_.vkCmdBindPipeline(commands_, point, pipeline.pipeline());
    if (bindings) {
        const VkDescriptorSet set = bindings->set();
        fn_.vkCmdBindDescriptorSets(commands_, point, layout.pipeline, 0, 1, &set, 0, nullptr);
    }
    if (!push_constants.empty())
        fn_.vkCmdPushConstants(commands_, layout.pipeline, stage_flags(layout.stage), 0, layout.push_constant_bytes,
                               push_constants.data());
}

void CommandList::dispatch(const rhi::DispatchDesc& desc) {
    const PipelineObject* pipeline = device_.objects().pipelines.find(desc.pipeline);
    const BindingSetObject* bindings = device_.objects().binding_sets.find(desc.bindings);
    if (!allowed("dispatch", rhi::complaint(desc, facts_of(pipeline).get(), facts_of(bindings).get()))) return;
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, *pipeline, bindings, desc.push_constants);
    fn_.vkCmdDispatch(commands_, desc.groups[0], desc.groups[1], desc.groups[2]);
}

void CommandList::draw_fullscreen(const rhi::DrawDesc& desc) {
    const PipelineObject* pipeline = device_.objects().pipelines.find(desc.pipeline);
    const BindingSetObject* bindings = device_.objects().binding_sets.find(desc.bindings);
    const TextureObject* target = device_.objects().textures.find(desc.target);
    const rhi::TextureDesc* target_desc = target ? &target->desc() : nullptr;
    if (!allowed("draw_fullscreen", rhi::complaint(desc, facts_of(pipeline).get(), facts_of(bindings).get(), target_desc)))
        return;
    if (!allowed("draw_fullscreen", graphics_ ? "" : "draw_fullscreen: the queue of this recording has no graphics")) return;
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, *pipeline, bindings, desc.push_constants);
    const rhi::Extent& extent = target->desc().extent;
    const VkRect2D area = {{0, 0}, {extent.width, extent.height}};
    const VkViewport viewport = {0.0f, 0.0f, static_cast<float>(extent.width), static_cast<float>(extent.height), 0.0f, 1.0f};
    fn_.vkCmdSetViewport(commands_, 0, 1, &viewport);
    fn_.vkCmdSetScissor(commands_, 0, 1, &area);
    VkRenderPassBeginInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = pipeline->render_pass();
    info.framebuffer = target->framebuffer();
    info.renderArea = area;
    fn_.vkCmdBeginRenderPass(commands_, &info, VK_SUBPASS_CONTENTS_INLINE);
    fn_.vkCmdDraw(commands_, 3, 1, 0, 0);
    fn_.vkCmdEndRenderPass(commands_);
}

void CommandList::begin_marker(const char* name) {
    if (!allowed("begin_marker")) return;
    ++open_markers_;
    if (!context_.debug_utils) return;
    VkDebugUtilsLabelEXT label = {};
    label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
    label.pLabelName = name ? name : "";
    context_.instance_functions.vkCmdBeginDebugUtilsLabelEXT(commands_, &label);
}

void CommandList::end_marker() {
    if (!allowed("end_marker", open_markers_ == 0 ? "end_marker: no marker is open" : "")) return;
    --open_markers_;
    if (context_.debug_utils) context_.instance_functions.vkCmdEndDebugUtilsLabelEXT(commands_);
}

void CommandList::timestamp(std::uint32_t index) {
    const std::uint32_t slots = device_.timestamps().slots();
    if (!allowed("timestamp", timestamps_ ? "" : "timestamp: the queue of this recording has none")) return;
    if (!allowed("timestamp", index < slots ? "" : too_high("timestamp: index", index, slots))) return;
    device_.timestamps().record(commands_, index);
}

}  // namespace aureole::vulkan
