// The images of the window's surface: one picture is blitted into each and shown.
#pragma once

#include "viewer/ui/gpu.h"

#include <vector>

namespace aureole::viewer {

class Swapchain {
public:
    /// `wanted`: in pixels, where the surface leaves the choice.
    Swapchain(Gpu& gpu, VkExtent2D wanted);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    [[nodiscard]] VkExtent2D extent() const noexcept { return extent_; }
    /// Records with `draw`, which leaves `source` in TRANSFER_SRC_OPTIMAL, shows it, and waits until it has been drawn. False:
    /// the surface has changed, and another swapchain is needed; nothing may have been shown then, but all has been drawn.
    [[nodiscard]] bool show(const GpuImage& source, const std::function<void(VkCommandBuffer)>& draw);

private:
    void make(VkExtent2D wanted);
    void destroy() noexcept;

    Gpu& gpu_;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkExtent2D extent_{};
    std::vector<VkImage> images_;
    std::vector<VkSemaphore> drawn_;  ///< Of each image: presenting waits for it.
    VkSemaphore acquired_ = VK_NULL_HANDLE;
    VkFence done_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

}  // namespace aureole::viewer
