// rhi::Format as VkFormat, and what the device can do with it.
#pragma once

#include "functions.h"

#include <aureole/rhi/device.h>

namespace aureole::vulkan {

[[nodiscard]] VkFormat to_vulkan(rhi::Format format) noexcept;
[[nodiscard]] VkImageAspectFlags aspect_of(rhi::Format format) noexcept;
[[nodiscard]] VkImageType image_type(rhi::Dimension dimension) noexcept;
[[nodiscard]] VkImageCreateFlags image_flags(rhi::Dimension dimension) noexcept;
[[nodiscard]] constexpr std::uint32_t layer_count(rhi::Dimension dimension) noexcept {
    return dimension == rhi::Dimension::cube ? 6 : 1;
}
[[nodiscard]] VkImageUsageFlags image_usage(rhi::Usage usage) noexcept;

/// `graphics`: colour attachments are of use only where there is a graphics queue.
[[nodiscard]] rhi::FormatSupport format_support(const InstanceFunctions& functions, VkPhysicalDevice device, bool graphics,
                                                rhi::Format format, rhi::Dimension dimension);

/// Limits of images of one kind; nothing (maxExtent 0) if the device has none such.
[[nodiscard]] VkImageFormatProperties image_limits(const InstanceFunctions& functions, VkPhysicalDevice device,
                                                   rhi::Format format, rhi::Dimension dimension, VkImageUsageFlags usage);

}  // namespace aureole::vulkan
