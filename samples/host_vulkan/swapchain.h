// The images of the window.
#pragma once

#include "host_vulkan/device.h"

#include <optional>
#include <vector>

namespace host_vulkan {

class Swapchain {
public:
    /// `old`: what the window had before, or null; it is to be destroyed afterwards.
    Swapchain(const Device& device, VkExtent2D size, const Swapchain* old);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    struct Target {
        VkImage image;
        VkImageView view;
        VkSemaphore rendered;  ///< To be signalled when the image may be shown.
    };
    /// Index of the next image, which is there when `acquired` is signalled; none where the window has another size by now.
    [[nodiscard]] std::optional<std::uint32_t> acquire(VkSemaphore acquired);
    /// False where the window has another size by now.
    [[nodiscard]] bool present(std::uint32_t index);

    [[nodiscard]] const Target& target(std::uint32_t index) const { return targets_[index]; }
    [[nodiscard]] VkExtent2D extent() const noexcept { return extent_; }
    [[nodiscard]] VkFormat format() const noexcept { return format_.format; }
    /// The format does what encoding of sRGB there is to do.
    [[nodiscard]] bool encodes() const noexcept;
    [[nodiscard]] bool can_be_copied() const noexcept { return copied_; }

private:
    const Device& device_;
    VkSwapchainKHR handle_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_ = {};
    VkExtent2D extent_ = {};
    bool copied_ = false;
    std::vector<Target> targets_;
};

}  // namespace host_vulkan
