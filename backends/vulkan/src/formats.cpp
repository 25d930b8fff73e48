#include "formats.h"

namespace aureole::vulkan {

VkFormat to_vulkan(rhi::Format format) noexcept {
    switch (format) {
        case rhi::Format::undefined:
            return VK_FORMAT_UNDEFINED;
        case rhi::Format::r8_unorm:
            return VK_FORMAT_R8_UNORM;
        case rhi::Format::rgba8_unorm:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case rhi::Format::rgba8_srgb:
            return VK_FORMAT_R8G8B8A8_SRGB;
        case rhi::Format::bgra8_unorm:
            return VK_FORMAT_B8G8R8A8_UNORM;
        case rhi::Format::r16_float:
            return VK_FORMAT_R16_SFLOAT;
        case rhi::Format::rg16_float:
            return VK_FORMAT_R16G16_SFLOAT;
        case rhi::Format::rgba16_float:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case rhi::Format::r32_float:
            return VK_FORMAT_R32_SFLOAT;
        case rhi::Format::rg32_float:
            return VK_FORMAT_R32G32_SFLOAT;
        case rhi::Format::rgba32_float:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        case rhi::Format::r11g11b10_float:
            return VK_FORMAT_B10G11R11_UFLOAT_PACK32;
        case rhi::Format::d32_float:
            return VK_FORMAT_D32_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkImageAspectFlags aspect_of(rhi::Format format) noexcept {
    return format == rhi::Format::d32_float ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageType image_type(rhi::Dimension dimension) noexcept {
    return dimension == rhi::Dimension::d3 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
}

VkImageCreateFlags image_flags(rhi::Dimension dimension) noexcept {
    return dimension == rhi::Dimension::cube ? VkImageCreateFlags{VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT} : VkImageCreateFlags{0};
}

VkImageUsageFlags image_usage(rhi::Usage usage) noexcept {
    VkImageUsageFlags flags = 0;
    if (has(usage, rhi::Usage::sampled)) flags |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (has(usage, rhi::Usage::storage)) flags |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (has(usage, rhi::Usage::color_attachment)) flags |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (has(usage, rhi::Usage::copy_source)) flags |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (has(usage, rhi::Usage::copy_destination)) flags |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return flags;
}

VkImageFormatProperties image_limits(const InstanceFunctions& functions, VkPhysicalDevice device, rhi::Format format,
                                     rhi::Dimension dimension, VkImageUsageFlags usage) {
    VkImageFormatProperties limits = {};
    const VkResult result = functions.vkGetPhysicalDeviceImageFormatProperties(
        device, to_vulkan(format), image_type(dimension), VK_IMAGE_TILING_OPTIMAL, usage, image_flags(dimension), &limits);
    return result == VK_SUCCESS ? limits : VkImageFormatProperties{};
}

rhi::FormatSupport format_support(const InstanceFunctions& functions, VkPhysicalDevice device, bool graphics,
                                  rhi::Format format, rhi::Dimension dimension) {
    if (format == rhi::Format::undefined) return {};
    VkFormatProperties properties = {};
    functions.vkGetPhysicalDeviceFormatProperties(device, to_vulkan(format), &properties);
    const auto supports = [&](VkFormatFeatureFlags feature, VkImageUsageFlags usage) {
        return (properties.optimalTilingFeatures & feature) != 0 &&
               image_limits(functions, device, format, dimension, usage).maxExtent.width > 0;
    };
    rhi::FormatSupport support;
    support.sampled = supports(VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, VK_IMAGE_USAGE_SAMPLED_BIT);
    support.linear_filter = supports(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT, VK_IMAGE_USAGE_SAMPLED_BIT);
    support.storage = supports(VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT, VK_IMAGE_USAGE_STORAGE_BIT);
    support.color_attachment = graphics && dimension == rhi::Dimension::d2 &&
                               supports(VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    return support;
}

}  // namespace aureole::vulkan
