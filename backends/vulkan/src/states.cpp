#include "states.h"

namespace aureole::vulkan {

StateAccess access_of(rhi::State state, bool graphics, VkImageLayout read_layout) noexcept {
    const VkPipelineStageFlags fragment = graphics ? VkPipelineStageFlags{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT} : 0;
    const VkPipelineStageFlags shaders = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | fragment;
    switch (state) {
        case rhi::State::undefined:
            return {};
        case rhi::State::sampled:
        case rhi::State::depth_read:
            return {shaders, VK_ACCESS_SHADER_READ_BIT, 0, read_layout};
        case rhi::State::storage_write:
            return {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
        case rhi::State::color_attachment:
            return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
        case rhi::State::copy_source:
            return {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, 0, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
        case rhi::State::copy_destination:
            return {VK_PIPELINE_STAGE_TRANSFER_BIT, 0, VK_ACCESS_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
        case rhi::State::constants:
            return {shaders, VK_ACCESS_UNIFORM_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
        case rhi::State::general:
            break;
    }
    return {VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_READ_BIT, VK_ACCESS_MEMORY_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
}

StateAccess unknown_access() noexcept {
    return {VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_ACCESS_MEMORY_READ_BIT, VK_ACCESS_MEMORY_WRITE_BIT,
            VK_IMAGE_LAYOUT_UNDEFINED};
}

}  // namespace aureole::vulkan
