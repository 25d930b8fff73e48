// What all objects of one device share.
#pragma once

#include "functions.h"
#include "memory.h"
#include "messages.h"
#include "physical_device.h"

#include <array>
#include <memory>
#include <string>

namespace aureole::vulkan {

struct ContextDesc {
    InstanceFunctions functions;
    VkInstance instance = VK_NULL_HANDLE;
    PhysicalDevice physical;
    VkDevice device = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    std::uint32_t second_queue_family = VK_QUEUE_FAMILY_IGNORED;  ///< Shares all objects; ignored: there is none.
    Ownership ownership = Ownership::own;
    bool debug_utils = false;
    VkPipelineCache pipeline_cache = VK_NULL_HANDLE;  ///< The host's; null makes one.
};

/// Functions, limits, memory and pipeline cache of one VkDevice. Does not own the VkDevice.
class Context {
public:
    /// Throws Error and leaves nothing behind.
    explicit Context(const ContextDesc& desc);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const noexcept { return physical.properties.limits; }
    /// Gives an object its name in debuggers and validation messages.
    void set_name(VkObjectType type, std::uint64_t handle, const std::string& name) const noexcept;
    template <class NativeHandle>
    void set_name(VkObjectType type, NativeHandle handle, const std::string& name) const noexcept {
        set_name(type, reinterpret_cast<std::uint64_t>(handle), name);
    }

    /// For VkImageCreateInfo and VkBufferCreateInfo: which queue families use the object.
    template <class Info>
    void share(Info& info) const noexcept {
        info.sharingMode = families[1] == VK_QUEUE_FAMILY_IGNORED ? VK_SHARING_MODE_EXCLUSIVE : VK_SHARING_MODE_CONCURRENT;
        info.queueFamilyIndexCount = info.sharingMode == VK_SHARING_MODE_CONCURRENT ? 2 : 0;
        info.pQueueFamilyIndices = families.data();
    }

    const InstanceFunctions instance_functions;
    const DeviceFunctions fn;
    const VkInstance instance;
    const PhysicalDevice physical;
    const VkDevice device;
    const std::uint32_t queue_family;
    const std::array<std::uint32_t, 2> families;  ///< `queue_family`, and the second one or VK_QUEUE_FAMILY_IGNORED.
    const bool graphics;                          ///< The queue draws.
    const bool debug_utils;                       ///< Names and markers work.
    Memory memory;
    VkPipelineCache pipeline_cache;

private:
    bool own_pipeline_cache_;
};

}  // namespace aureole::vulkan
