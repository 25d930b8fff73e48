// What each frame in flight has of its own, and how a frame reaches the queues.
#pragma once

#include "host_vulkan/resources.h"
#include "host_vulkan/swapchain.h"

#include <memory>
#include <vector>

namespace host_vulkan {

/// The parts of a frame, in order. One queue runs them as one command buffer. With asynchronous compute they are four, and
/// `tables` go to the second queue, beside `depth`:
///
///     queue           shadows ──►        depth          picture(n) ──► shadows(n + 1)
///                            └─► semaphore      semaphore ──┘
///     compute queue              tables ────────────┘
///
/// The tables of frame n + 1 wait for its shadows, which stand behind the picture of frame n on their queue: so nothing that
/// still reads the tables is overtaken, and two semaphores a frame are all there is to it.
struct FrameCommands {
    VkCommandBuffer shadows = VK_NULL_HANDLE, tables = VK_NULL_HANDLE, depth = VK_NULL_HANDLE, picture = VK_NULL_HANDLE;
};

struct Frame {
    FrameCommands commands;
    std::uint64_t number = 0;  ///< Of what it was last used for; frames count from 1.
    std::unique_ptr<Buffer> uniforms;
    VkDescriptorSet set = VK_NULL_HANDLE;  ///< The renderer's.
    VkSemaphore acquired = VK_NULL_HANDLE;

    VkCommandPool pool = VK_NULL_HANDLE, compute_pool = VK_NULL_HANDLE;
    VkFence done = VK_NULL_HANDLE;
    VkSemaphore shadows_done = VK_NULL_HANDLE, tables_done = VK_NULL_HANDLE;
};

class FrameRing {
public:
    FrameRing(const Device& device, std::uint32_t frames, bool async_compute, VkDeviceSize uniform_bytes);
    ~FrameRing();
    FrameRing(const FrameRing&) = delete;
    FrameRing& operator=(const FrameRing&) = delete;

    /// The frame whose turn it is, once the device has finished what it was used for before (`number`).
    [[nodiscard]] Frame& wait();
    /// Starts its recording as frame `number`; `wait` gives the next one from here on.
    void begin(Frame& frame, std::uint64_t number);
    /// Ends its recording and submits it; `target` is rendered to by the last part alone.
    void submit(Frame& frame, const Swapchain::Target& target) const;

    [[nodiscard]] std::vector<Frame>& all() noexcept { return frames_; }

private:
    void make(Frame& frame, VkDeviceSize uniform_bytes);
    void make_commands(Frame& frame) const;

    const Device& device_;
    bool async_;
    std::vector<Frame> frames_;
    std::size_t next_ = 0;
};

}  // namespace host_vulkan
