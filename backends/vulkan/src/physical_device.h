// What a physical device can do, and whether that is enough.
#pragma once

#include "functions.h"

#include <aureole/vulkan/vulkan_device.h>

#include <cstdint>
#include <string>
#include <vector>

namespace aureole::vulkan {

struct PhysicalDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties = {};
    VkPhysicalDeviceFeatures features = {};  ///< Supported; enabled ones are the VkDevice's.
    std::vector<VkQueueFamilyProperties> queue_families;
    VkDeviceSize max_allocation_size = 0;  ///< Bytes of one VkDeviceMemory.
    std::string driver;

    [[nodiscard]] bool has_graphics(std::uint32_t family) const {
        return (queue_families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
    }
};

/// Reads everything about one device. Its version may be below 1.1; then only the fields that Vulkan 1.0 knows are filled.
[[nodiscard]] PhysicalDevice describe(const InstanceFunctions& functions, VkPhysicalDevice handle);

/// All devices of an instance. Throws Error.
[[nodiscard]] std::vector<PhysicalDevice> enumerate(const InstanceFunctions& functions, VkInstance instance);

/// Why Aureole cannot use a device with `features` enabled; empty if it can.
[[nodiscard]] std::string problem_of(const PhysicalDevice& device, const VkPhysicalDeviceFeatures& features);

/// The queue family to use: graphics and compute if possible, so that raster passes work. Only for a device without problem.
[[nodiscard]] std::uint32_t choose_queue_family(const PhysicalDevice& device);

/// The usable devices that `desc` allows, the best first; at least one. Throws Error (see create_vulkan_device).
[[nodiscard]] std::vector<const PhysicalDevice*> choose(const std::vector<PhysicalDevice>& devices,
                                                        const VulkanDeviceDesc& desc);

/// An entry of list_vulkan_devices.
[[nodiscard]] VulkanDeviceInfo info_of(const PhysicalDevice& device, std::uint32_t index);

/// "1.3.230"
[[nodiscard]] std::string version_text(std::uint32_t version);

}  // namespace aureole::vulkan
