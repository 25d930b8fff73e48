// Collects barriers and records them together, without allocation.
#pragma once

#include "buffer.h"
#include "texture.h"

namespace aureole::vulkan {

class BarrierBatch {
public:
    /// `graphics`: the queue that `commands` go to draws.
    BarrierBatch(const Context& context, VkCommandBuffer commands, bool graphics)
        : context_(context), commands_(commands), graphics_(graphics) {}
    ~BarrierBatch() { flush(); }
    BarrierBatch(const BarrierBatch&) = delete;
    BarrierBatch& operator=(const BarrierBatch&) = delete;

    void add(TextureObject& texture, rhi::State before, rhi::State after) noexcept;
    void add(BufferObject& buffer, rhi::State before, rhi::State after) noexcept;
    void flush() noexcept;

private:
    static constexpr std::uint32_t capacity = 16;
    const Context& context_;
    VkCommandBuffer commands_;
    bool graphics_;
    VkPipelineStageFlags before_ = 0, after_ = 0;
    std::uint32_t image_count_ = 0, buffer_count_ = 0;
    VkImageMemoryBarrier images_[capacity];
    VkBufferMemoryBarrier buffers_[capacity];
};

}  // namespace aureole::vulkan
