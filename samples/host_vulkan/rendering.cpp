#include "host_vulkan/rendering.h"

namespace host_vulkan {
namespace {

VkRenderingAttachmentInfo attachment_info(const Attachment& attachment) {
    auto info = info_of<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    info.imageView = attachment.view;
    info.imageLayout = attachment.layout;
    info.loadOp = attachment.load == Load::clear  ? VK_ATTACHMENT_LOAD_OP_CLEAR
                  : attachment.load == Load::keep ? VK_ATTACHMENT_LOAD_OP_LOAD
                                                  : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    for (float& channel : info.clearValue.color.float32) channel = attachment.value;
    return info;
}

}  // namespace

void begin_rendering(VkCommandBuffer commands, VkExtent2D extent, const Attachment& color, const Attachment& depth) {
    const VkRenderingAttachmentInfo color_info = attachment_info(color);
    VkRenderingAttachmentInfo depth_info = attachment_info(depth);
    depth_info.clearValue = {};
    depth_info.clearValue.depthStencil = {depth.value, 0};
    if (depth.load == Load::keep) depth_info.storeOp = VK_ATTACHMENT_STORE_OP_NONE;
    auto info = info_of<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = {{0, 0}, extent};
    info.layerCount = 1;
    info.colorAttachmentCount = color.view ? 1 : 0;
    info.pColorAttachments = &color_info;
    info.pDepthAttachment = depth.view ? &depth_info : nullptr;
    vkCmdBeginRendering(commands, &info);
}

void set_viewport(VkCommandBuffer commands, const VkRect2D& area, bool y_up) {
    const auto x = static_cast<float>(area.offset.x), y = static_cast<float>(area.offset.y);
    const auto width = static_cast<float>(area.extent.width), height = static_cast<float>(area.extent.height);
    const VkViewport viewport = {x, y_up ? y + height : y, width, y_up ? -height : height, 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
}

}  // namespace host_vulkan
