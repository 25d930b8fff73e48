#include "barriers.h"

namespace aureole::vulkan {
namespace {

constexpr VkPipelineStageFlags stages_without_graphics = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT |
                                                         VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT |
                                                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;

/// What must have ended: accesses in `before`, or, where the contents no longer matter, whatever was done last.
StateAccess source_of(rhi::State before, const StateAccess& last, bool graphics,
                      VkImageLayout read_layout = VK_IMAGE_LAYOUT_UNDEFINED) noexcept {
    if (before != rhi::State::undefined) return access_of(before, graphics, read_layout);
    StateAccess source = last;
    source.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    return source;
}

/// Reading goes on as before.
bool is_needless(const StateAccess& source, const StateAccess& destination) noexcept {
    return source.writes == 0 && source == destination;
}

}  // namespace

void BarrierBatch::add(TextureObject& texture, rhi::State before, rhi::State after) noexcept {
    // Nothing can be moved to `undefined`: the texture stays as it is until its contents are replaced.
    if (after == rhi::State::undefined) return;
    const StateAccess source = source_of(before, texture.last_access, graphics_, texture.read_layout());
    const StateAccess destination = access_of(after, graphics_, texture.read_layout());
    texture.last_access = destination;
    texture.last_state = after;
    if (is_needless(source, destination)) return;

    if (image_count_ == capacity) flush();
    VkImageMemoryBarrier& barrier = images_[image_count_++];
    barrier = {};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = source.writes;
    barrier.dstAccessMask = destination.reads | destination.writes;
    barrier.oldLayout = source.layout;
    barrier.newLayout = destination.layout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = texture.image();
    barrier.subresourceRange = texture.whole();
    before_ |= source.stages;
    after_ |= destination.stages;
}

void BarrierBatch::add(BufferObject& buffer, rhi::State before, rhi::State after) noexcept {
    if (after == rhi::State::undefined) return;
    StateAccess source = source_of(before, buffer.last_access, graphics_);
    StateAccess destination = access_of(after, graphics_);
    source.layout = destination.layout = VK_IMAGE_LAYOUT_UNDEFINED;  // Buffers have none.
    buffer.last_access = destination;
    if (is_needless(source, destination)) return;

    if (buffer_count_ == capacity) flush();
    VkBufferMemoryBarrier& barrier = buffers_[buffer_count_++];
    barrier = {};
    barrier.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER;
    barrier.srcAccessMask = source.writes;
    barrier.dstAccessMask = destination.reads | destination.writes;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer.buffer();
    barrier.size = VK_WHOLE_SIZE;
    before_ |= source.stages;
    after_ |= destination.stages;
}

void BarrierBatch::flush() noexcept {
    if (image_count_ + buffer_count_ == 0) return;
    // What another queue did last has ended there, by semaphores; this one may name its own stages alone.
    if (!graphics_) before_ &= stages_without_graphics;
    if (before_ == 0) before_ = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT;
    context_.fn.vkCmdPipelineBarrier(commands_, before_, after_, 0, 0, nullptr, buffer_count_, buffers_, image_count_, images_);
    image_count_ = buffer_count_ = 0;
    before_ = after_ = 0;
}

}  // namespace aureole::vulkan
