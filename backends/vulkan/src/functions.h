// The Vulkan functions of one instance and one device, and nothing global: several devices, and a host with a loader of its
// own, live side by side. A function that this backend calls stands in one of these lists, so that a missing one is found,
// by name, before the first call.
#pragma once

#include "volk_private.h"

namespace aureole::vulkan {

#define AUREOLE_GLOBAL_FUNCTIONS(X)           \
    X(vkCreateInstance)                       \
    X(vkEnumerateInstanceExtensionProperties) \
    X(vkEnumerateInstanceLayerProperties)     \
    X(vkEnumerateInstanceVersion)

#define AUREOLE_INSTANCE_FUNCTIONS(X)           \
    X(vkGetDeviceProcAddr)                      \
    X(vkGetPhysicalDeviceFeatures)              \
    X(vkGetPhysicalDeviceFormatProperties)      \
    X(vkGetPhysicalDeviceImageFormatProperties) \
    X(vkGetPhysicalDeviceMemoryProperties)      \
    X(vkGetPhysicalDeviceProperties)            \
    X(vkGetPhysicalDeviceProperties2)           \
    X(vkGetPhysicalDeviceQueueFamilyProperties) \
    X(vkEnumerateDeviceExtensionProperties)

/// Called only for an instance of our own.
#define AUREOLE_OWN_INSTANCE_FUNCTIONS(X) \
    X(vkCreateDevice)                     \
    X(vkDestroyInstance)                  \
    X(vkEnumeratePhysicalDevices)

/// VK_EXT_debug_utils; all null where the extension is not enabled.
#define AUREOLE_DEBUG_FUNCTIONS(X)     \
    X(vkCmdBeginDebugUtilsLabelEXT)    \
    X(vkCmdEndDebugUtilsLabelEXT)      \
    X(vkCreateDebugUtilsMessengerEXT)  \
    X(vkDestroyDebugUtilsMessengerEXT) \
    X(vkSetDebugUtilsObjectNameEXT)

#define AUREOLE_DEVICE_FUNCTIONS(X)  \
    X(vkAllocateDescriptorSets)      \
    X(vkAllocateMemory)              \
    X(vkBindBufferMemory)            \
    X(vkBindImageMemory)             \
    X(vkCmdBeginRenderPass)          \
    X(vkCmdBindDescriptorSets)       \
    X(vkCmdBindPipeline)             \
    X(vkCmdCopyBufferToImage)        \
    X(vkCmdCopyImage)                \
    X(vkCmdCopyImageToBuffer)        \
    X(vkCmdDispatch)                 \
    X(vkCmdDraw)                     \
    X(vkCmdEndRenderPass)            \
    X(vkCmdPipelineBarrier)          \
    X(vkCmdPushConstants)            \
    X(vkCmdResetQueryPool)           \
    X(vkCmdSetScissor)               \
    X(vkCmdSetViewport)              \
    X(vkCmdUpdateBuffer)             \
    X(vkCmdWriteTimestamp)           \
    X(vkCreateBuffer)                \
    X(vkCreateComputePipelines)      \
    X(vkCreateDescriptorPool)        \
    X(vkCreateDescriptorSetLayout)   \
    X(vkCreateFramebuffer)           \
    X(vkCreateGraphicsPipelines)     \
    X(vkCreateImage)                 \
    X(vkCreateImageView)             \
    X(vkCreatePipelineCache)         \
    X(vkCreatePipelineLayout)        \
    X(vkCreateQueryPool)             \
    X(vkCreateRenderPass)            \
    X(vkCreateSampler)               \
    X(vkCreateShaderModule)          \
    X(vkDestroyBuffer)               \
    X(vkDestroyDescriptorPool)       \
    X(vkDestroyDescriptorSetLayout)  \
    X(vkDestroyFramebuffer)          \
    X(vkDestroyImage)                \
    X(vkDestroyImageView)            \
    X(vkDestroyPipeline)             \
    X(vkDestroyPipelineCache)        \
    X(vkDestroyPipelineLayout)       \
    X(vkDestroyQueryPool)            \
    X(vkDestroyRenderPass)           \
    X(vkDestroySampler)              \
    X(vkDestroyShaderModule)         \
    X(vkFreeDescriptorSets)          \
    X(vkFreeMemory)                  \
    X(vkGetBufferMemoryRequirements) \
    X(vkGetImageMemoryRequirements)  \
    X(vkGetQueryPoolResults)         \
    X(vkMapMemory)                   \
    X(vkUpdateDescriptorSets)

/// Called only for a device of our own.
#define AUREOLE_OWN_DEVICE_FUNCTIONS(X) \
    X(vkAllocateCommandBuffers)         \
    X(vkBeginCommandBuffer)             \
    X(vkCreateCommandPool)              \
    X(vkCreateFence)                    \
    X(vkDestroyCommandPool)             \
    X(vkDestroyDevice)                  \
    X(vkDestroyFence)                   \
    X(vkDeviceWaitIdle)                 \
    X(vkEndCommandBuffer)               \
    X(vkGetDeviceQueue)                 \
    X(vkQueueSubmit)                    \
    X(vkResetCommandPool)               \
    X(vkResetFences)                    \
    X(vkWaitForFences)

#define AUREOLE_DECLARE_FUNCTION(name) PFN_##name name = nullptr;

struct GlobalFunctions {
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    AUREOLE_GLOBAL_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
};

struct InstanceFunctions {
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    AUREOLE_INSTANCE_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
    AUREOLE_OWN_INSTANCE_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
    AUREOLE_DEBUG_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
};

struct DeviceFunctions {
    AUREOLE_DEVICE_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
    AUREOLE_OWN_DEVICE_FUNCTIONS(AUREOLE_DECLARE_FUNCTION)
};

#undef AUREOLE_DECLARE_FUNCTION

/// Whose objects the functions are for: of a host's, fewer are needed.
enum class Ownership { own, borrowed };

/// The system's Vulkan loader, opened on first use and kept. Null if there is none.
[[nodiscard]] PFN_vkGetInstanceProcAddr system_loader();

/// All three throw Error(unsupported) that names the first missing function.
[[nodiscard]] GlobalFunctions load_global_functions(PFN_vkGetInstanceProcAddr loader);
[[nodiscard]] InstanceFunctions load_instance_functions(PFN_vkGetInstanceProcAddr loader, VkInstance instance,
                                                        Ownership ownership, bool debug_utils);
[[nodiscard]] DeviceFunctions load_device_functions(const InstanceFunctions& instance, VkDevice device, Ownership ownership);

}  // namespace aureole::vulkan
