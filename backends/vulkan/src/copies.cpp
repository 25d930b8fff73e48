// The copies of a command list: whole textures, all faces of a cube, depth through its own aspect.
#include "command_list.h"

namespace aureole::vulkan {

void CommandList::copy(const rhi::CopyDesc& desc) {
    if (!allowed("copy", rhi::complaint(desc, device_.objects()))) return;
    const auto& textures = device_.objects().textures;
    const auto& buffers = device_.objects().buffers;
    if (const auto* c = std::get_if<rhi::TextureToBuffer>(&desc))
        copy_to_buffer(*textures.find(c->source), *buffers.find(c->destination));
    else if (const auto* c = std::get_if<rhi::BufferToTexture>(&desc))
        copy_to_texture(*buffers.find(c->source), *textures.find(c->destination));
    else if (const auto* c = std::get_if<rhi::TextureToTexture>(&desc))
        copy_between(*textures.find(c->source), *textures.find(c->destination));
}

/// Between buffers and depth textures, only graphics queues copy.
bool CommandList::queue_copies(const TextureObject& texture) const noexcept {
    if (!texture.is_depth() || graphics_) return true;
    device_.sink().misuse("copy: " + rhi::field_name("texture", texture.desc().name, "") +
                          " is a depth texture and the queue has no graphics");
    return false;
}

void CommandList::copy_to_buffer(const TextureObject& source, const BufferObject& destination) noexcept {
    if (!queue_copies(source)) return;
    VkBufferImageCopy region = {};
    region.imageSubresource = source.layers();
    region.imageExtent = source.extent();
    fn_.vkCmdCopyImageToBuffer(commands_, source.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, destination.buffer(), 1,
                               &region);
    if (!has(destination.desc().usage, rhi::Usage::read_back)) return;

    // A fence says that the copy is done; this makes its bytes visible to the CPU.
    VkBufferMemoryBarrier visible = {};
    visible.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER;
    visible.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    visible.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    visible.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    visible.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    visible.buffer = destination.buffer();
    visible.size = VK_WHOLE_SIZE;
    fn_.vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 0, nullptr, 1, &visible,
                             0, nullptr);
}

void CommandList::copy_to_texture(const BufferObject& source, const TextureObject& destination) noexcept {
    if (!queue_copies(destination)) return;
    VkBufferImageCopy region = {};
    region.imageSubresource = destination.layers();
    region.imageExtent = destination.extent();
    fn_.vkCmdCopyBufferToImage(commands_, source.buffer(), destination.image(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                               &region);
}

void CommandList::copy_between(const TextureObject& source, const TextureObject& destination) noexcept {
    VkImageCopy region = {};
    region.srcSubresource = source.layers();
    region.dstSubresource = destination.layers();
    region.extent = source.extent();
    fn_.vkCmdCopyImage(commands_, source.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, destination.image(),
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

}  // namespace aureole::vulkan
