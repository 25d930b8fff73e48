// What a window's surface and a Vulkan device offer, as the samples choose it. Functions of Vulkan are those that are declared
// before this header: volk's, or the loader's own.
#pragma once

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace aureole::app {

/// The format encodes what is rendered or blitted into it by the curve of sRGB.
inline bool encodes_srgb(VkFormat format) { return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB; }

/// Of 8 bits, for a display of sRGB: rather one that does not encode, or rather one that does. None: the surface takes no such
/// format, or cannot be asked.
inline std::optional<VkSurfaceFormatKHR> surface_format(VkPhysicalDevice device, VkSurfaceKHR surface, bool rather_encoding) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    if (vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, formats.data()) != VK_SUCCESS) return {};
    for (const bool encoding : {rather_encoding, !rather_encoding})
        for (const VkSurfaceFormatKHR& offered : formats) {
            const bool plain = offered.format == VK_FORMAT_B8G8R8A8_UNORM || offered.format == VK_FORMAT_R8G8B8A8_UNORM;
            const bool fits = encoding ? encodes_srgb(offered.format) : plain;
            if (fits && offered.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return offered;
        }
    return {};
}

/// The surface's own size; what is wanted, within its limits, where it leaves the choice.
inline VkExtent2D surface_extent(const VkSurfaceCapabilitiesKHR& surface, VkExtent2D wanted) {
    if (surface.currentExtent.width != std::numeric_limits<std::uint32_t>::max()) return surface.currentExtent;
    return {std::clamp(wanted.width, surface.minImageExtent.width, surface.maxImageExtent.width),
            std::clamp(wanted.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

/// One image more than the surface needs, so that nobody waits for it.
inline std::uint32_t surface_images(const VkSurfaceCapabilitiesKHR& surface) {
    const std::uint32_t wanted = surface.minImageCount + 1;
    return surface.maxImageCount > 0 ? std::min(wanted, surface.maxImageCount) : wanted;
}

/// The first type of memory among these bits with these properties.
inline std::optional<std::uint32_t> memory_type(VkPhysicalDevice device, std::uint32_t bits, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory = {};
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((bits & (1U << i)) && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return {};
}

/// Warnings and errors of the validation layer.
inline VkDebugUtilsMessengerCreateInfoEXT messenger_info(PFN_vkDebugUtilsMessengerCallbackEXT callback, void* user) {
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = callback;
    info.pUserData = user;
    return info;
}

}  // namespace aureole::app
