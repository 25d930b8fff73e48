#include "render_pass.h"

#include "formats.h"
#include "result.h"

#include <string>

namespace aureole::vulkan {

RenderPasses::~RenderPasses() {
    for (const auto& [format, pass] : passes_) context_.fn.vkDestroyRenderPass(context_.device, pass, nullptr);
}

VkRenderPass RenderPasses::get(rhi::Format format) {
    for (const auto& [known, pass] : passes_)
        if (known == format) return pass;
    passes_.reserve(passes_.size() + 1);

    // The texture is in State::color_attachment before and after: barriers order it, so no subpass dependency is needed.
    VkAttachmentDescription attachment = {};
    attachment.format = to_vulkan(format);
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    attachment.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    attachment.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference target = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass = {};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &target;
    VkRenderPassCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &attachment;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass pass = VK_NULL_HANDLE;
    check_result(context_.fn.vkCreateRenderPass(context_.device, &info, nullptr, &pass), "vkCreateRenderPass",
                 std::string("render pass for ") + rhi::to_string(format));
    passes_.emplace_back(format, pass);
    return pass;
}

}  // namespace aureole::vulkan
