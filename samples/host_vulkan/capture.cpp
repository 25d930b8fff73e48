#include "host_vulkan/capture.h"

namespace host_vulkan {

Capture::Capture(const Device& device, VkFormat format, VkExtent2D extent)
    : format_(format),
      extent_(extent),
      buffer_(device, VkDeviceSize{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true) {}

Use Capture::record(VkCommandBuffer commands, VkImage image, const Use& last) const {
    auto over = info_of<VkBufferMemoryBarrier2>(VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2);
    over.srcStageMask = over.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;  // of the frame before
    over.srcAccessMask = over.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    over.srcQueueFamilyIndex = over.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    over.buffer = buffer_.buffer;
    over.size = VK_WHOLE_SIZE;
    VkBufferMemoryBarrier2 seen = over;
    seen.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    seen.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    auto info = info_of<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.bufferMemoryBarrierCount = 1;
    info.pBufferMemoryBarriers = &over;

    barrier(commands, image, VK_IMAGE_ASPECT_COLOR_BIT, last, uses::copy_source);
    vkCmdPipelineBarrier2(commands, &info);
    VkBufferImageCopy whole = {};
    whole.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    whole.imageExtent = {extent_.width, extent_.height, 1};
    vkCmdCopyImageToBuffer(commands, image, uses::copy_source.layout, buffer_.buffer, 1, &whole);
    info.pBufferMemoryBarriers = &seen;
    vkCmdPipelineBarrier2(commands, &info);
    return uses::copy_source;
}

aureole::app::DisplayImage Capture::read() const {
    const bool blue_first = format_ == VK_FORMAT_B8G8R8A8_UNORM || format_ == VK_FORMAT_B8G8R8A8_SRGB;
    aureole::app::DisplayImage image{extent_.width, extent_.height, {}};
    for (std::size_t pixel = 0; pixel < buffer_.bytes.size(); pixel += 4)
        for (const std::size_t channel : {0U, 1U, 2U})
            image.rgb.push_back(static_cast<std::uint8_t>(buffer_.bytes[pixel + (blue_first ? 2 - channel : channel)]));
    return image;
}

}  // namespace host_vulkan
