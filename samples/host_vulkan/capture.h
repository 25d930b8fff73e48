// Screenshots.
#pragma once

#include "host_vulkan/resources.h"
#include "io/image.h"

namespace host_vulkan {

/// A buffer that frames are copied into on their way to the window.
class Capture {
public:
    /// `format`: one of a swapchain's.
    Capture(const Device& device, VkFormat format, VkExtent2D extent);
    /// Copies an image that was last used so; returns its new use.
    [[nodiscard]] Use record(VkCommandBuffer commands, VkImage image, const Use& last) const;
    /// Of the last frame, once the device has finished it.
    [[nodiscard]] aureole::app::DisplayImage read() const;

private:
    const VkFormat format_;
    const VkExtent2D extent_;
    Buffer buffer_;
};

}  // namespace host_vulkan
