// The queue of a device of our own: one command buffer at a time.
#pragma once

#include "command_list.h"

namespace aureole::vulkan {

class Queue final : public rhi::Queue {
public:
    /// Throws Error and leaves nothing behind.
    Queue(Device& device, VkQueue queue);
    ~Queue() override;  ///< The device is idle.
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    /// Waits for what was submitted before. Throws Error: misuse (two begins), device_lost.
    [[nodiscard]] rhi::CommandList& begin() override;
    [[nodiscard]] std::uint64_t submit() override;
    void wait() override;

private:
    void wait_for_fence();
    void release() noexcept;

    Device& device_;
    const Context& context_;
    VkQueue queue_;
    CommandList list_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    std::uint64_t submitted_ = 0;  ///< Number of the last frame.
    bool in_flight_ = false;
};

}  // namespace aureole::vulkan
