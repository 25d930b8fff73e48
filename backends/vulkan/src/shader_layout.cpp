#include "pipeline.h"
#include "result.h"

#include <algorithm>
#include <string>

namespace aureole::vulkan {

VkDescriptorType descriptor_type(rhi::SlotKind kind) noexcept {
    switch (kind) {
        case rhi::SlotKind::sampled_texture:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case rhi::SlotKind::storage_texture:
            return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        case rhi::SlotKind::constants:
            break;
    }
    return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
}

VkShaderStageFlags stage_flags(rhi::Stage stage) noexcept {
    return stage == rhi::Stage::compute ? VK_SHADER_STAGE_COMPUTE_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
}

ShaderLayouts::~ShaderLayouts() {
    for (const auto& layout : layouts_) {
        context_.fn.vkDestroyPipelineLayout(context_.device, layout->pipeline, nullptr);
        context_.fn.vkDestroyDescriptorSetLayout(context_.device, layout->set, nullptr);
    }
}

const ShaderLayout& ShaderLayouts::get(const rhi::Shader& shader) {
    auto wanted = std::make_unique<ShaderLayout>();
    wanted->stage = shader.stage;
    wanted->push_constant_bytes = shader.push_constant_bytes;
    for (const rhi::SlotDesc& slot : shader.slots) wanted->slots.emplace_back(slot.slot, slot.kind);
    for (const auto& known : layouts_)
        if (known->stage == wanted->stage && known->push_constant_bytes == wanted->push_constant_bytes &&
            known->slots == wanted->slots)
            return *known;
    check_limits(shader);
    layouts_.reserve(layouts_.size() + 1);
    create(*wanted);
    layouts_.push_back(std::move(wanted));
    return *layouts_.back();
}

void ShaderLayouts::check_limits(const rhi::Shader& shader) const {
    const VkPhysicalDeviceLimits& limits = context_.limits();
    const struct {
        rhi::SlotKind kind;
        std::uint32_t allowed;
    } kinds[] = {{rhi::SlotKind::sampled_texture,
                  std::min(limits.maxPerStageDescriptorSamplers, limits.maxPerStageDescriptorSampledImages)},
                 {rhi::SlotKind::storage_texture, limits.maxPerStageDescriptorStorageImages},
                 {rhi::SlotKind::constants, limits.maxPerStageDescriptorUniformBuffers}};
    for (const auto& limit : kinds) {
        const auto same_kind = [&](const rhi::SlotDesc& slot) { return slot.kind == limit.kind; };
        const auto count = std::count_if(shader.slots.begin(), shader.slots.end(), same_kind);
        if (static_cast<std::uint64_t>(count) > limit.allowed)
            throw Error(ErrorCode::unsupported, "shader " + std::string(shader.name) + " slots",
                        std::to_string(count) + " of kind " + rhi::to_string(limit.kind),
                        "at most " + std::to_string(limit.allowed) + " on this device");
    }
}

void ShaderLayouts::create(ShaderLayout& layout) const {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const auto& [slot, kind] : layout.slots)
        bindings.push_back({slot, descriptor_type(kind), 1, stage_flags(layout.stage), nullptr});
    VkDescriptorSetLayoutCreateInfo set_info = {};
    set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set_info.pBindings = bindings.data();
    check_result(context_.fn.vkCreateDescriptorSetLayout(context_.device, &set_info, nullptr, &layout.set),
                 "vkCreateDescriptorSetLayout", "shader layout");

    const VkPushConstantRange push = {stage_flags(layout.stage), 0, layout.push_constant_bytes};
    VkPipelineLayoutCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &layout.set;
    info.pushConstantRangeCount = push.size > 0 ? 1 : 0;
    info.pPushConstantRanges = &push;
    const VkResult result = context_.fn.vkCreatePipelineLayout(context_.device, &info, nullptr, &layout.pipeline);
    if (result < VK_SUCCESS) context_.fn.vkDestroyDescriptorSetLayout(context_.device, layout.set, nullptr);
    check_result(result, "vkCreatePipelineLayout", "shader layout");
}

}  // namespace aureole::vulkan
