// Instance, surface, device and queues: the host's, as it would have them without Aureole.
#pragma once

#include "host_vulkan/vulkan.h"
#include "host_vulkan/window.h"

#include <atomic>
#include <string>

namespace host_vulkan {

class Device {
public:
    /// Throws std::runtime_error naming what is missing. `validate`: under the validation layer, with synchronization checks.
    Device(const Window& window, bool validate);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;
    /// What the second queue is, in words.
    [[nodiscard]] const char* describe_compute_queue() const;
    [[nodiscard]] int messages() const noexcept { return messages_; }

    // Set once, by the constructor.
    std::string name;
    VkInstance instance = VK_NULL_HANDLE;
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceFeatures features = {};  ///< As enabled.
    std::uint32_t family = 0;                ///< Of `queue`: with graphics, compute and presentation.
    VkQueue queue = VK_NULL_HANDLE;
    /// For asynchronous compute: of a family that computes alone, else another one of `family`, else `queue` itself.
    std::uint32_t compute_family = 0;
    VkQueue compute_queue = VK_NULL_HANDLE;
    const bool validated;

private:
    void make_instance();
    void choose();
    void make_device();
    void destroy() noexcept;
    static VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                                     const VkDebugUtilsMessengerCallbackDataEXT* data, void* device);

    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::atomic<int> messages_ = 0;
    std::uint32_t queues_ = 1;  ///< Of `family`.
};

}  // namespace host_vulkan
