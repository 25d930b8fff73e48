// The Vulkan backend: a headless device of its own, or a guest on a host's device.
//
// Needs Vulkan 1.1 and the feature shaderStorageImageWriteWithoutFormat; uses VK_EXT_debug_utils where it is there. The
// Vulkan loader is opened at run time: nothing here must be linked with libvulkan, and no symbol of it is defined here.
//
// What the states of aureole/rhi/types.h mean for a host's images (VkImageLayout):
//   undefined -> UNDEFINED, sampled -> SHADER_READ_ONLY_OPTIMAL, depth_read -> DEPTH_STENCIL_READ_ONLY_OPTIMAL,
//   storage_write and general -> GENERAL, color_attachment -> COLOR_ATTACHMENT_OPTIMAL,
//   copy_source -> TRANSFER_SRC_OPTIMAL, copy_destination -> TRANSFER_DST_OPTIMAL.
// General is for lending alone: an engine that keeps its images in GENERAL lends them so, and Aureole moves them out and back.
// Images have one mip level and the format that the texture descriptor names (d32_float: VK_FORMAT_D32_SFLOAT, without
// stencil), cubes are cube-compatible with six layers, and were made with the usage that the descriptor states.
#pragma once

#include <aureole/rhi/device.h>
#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace aureole::vulkan {

/// One device as `list_vulkan_devices` found it.
struct VulkanDeviceInfo {
    std::uint32_t index = 0;    ///< Position in the list; what VulkanDeviceDesc::index selects.
    std::string name{};         ///< As the driver says it, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
    std::string type{};         ///< "discrete", "integrated", "virtual", "cpu" or "other".
    std::string driver{};       ///< Driver and version, e.g. "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)".
    std::string api_version{};  ///< Highest Vulkan version of the device, e.g. "1.3.230".
    std::string problem{};      ///< Why Aureole cannot use it; empty if it can.
};

/// What list_vulkan_devices found.
struct VulkanDeviceList {
    std::vector<VulkanDeviceInfo> devices{};  ///< In the loader's order.
    std::string problem{};                    ///< Why there can be no device at all (no loader, too old); else empty.
    bool validation_available = false;        ///< VulkanDeviceDesc::validation can be asked for.
};

/// What can run here, and why something cannot. Never throws for lack of Vulkan: that is `problem`.
/// `loader`: see VulkanDeviceDesc::loader.
[[nodiscard]] VulkanDeviceList list_vulkan_devices(PFN_vkGetInstanceProcAddr loader = nullptr);

/// Which device to make and how.
struct VulkanDeviceDesc {
    /// Position in list_vulkan_devices(); -1 prefers discrete to integrated to virtual to CPU devices, and tries the next one,
    /// with a warning, if a device cannot be opened. Else Error(invalid_argument).
    int index = -1;
    /// Part of the device's name, upper or lower case; empty: any name. No match is an Error(unsupported).
    std::string name{};
    /// Run under the Khronos validation layer with synchronization checks; findings go to the message callback as
    /// Severity::error and Severity::warning. Error(unsupported) if the layer is not installed.
    bool validation = false;
    /// Messages from the very start; later rhi::Device::set_message_callback replaces it. Null: silent.
    rhi::MessageCallback message_callback = nullptr;
    void* message_user = nullptr;  ///< Given to the callback.
    /// Entry point of the Vulkan loader to use; null opens the system's (libvulkan.so.1).
    PFN_vkGetInstanceProcAddr loader = nullptr;
};

/// Native objects of a device, for programs that add Vulkan work of their own. Owned by the device.
struct VulkanHandles {
    VkInstance instance = VK_NULL_HANDLE;               ///< Of Vulkan 1.1 at least.
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;  ///< That the device was made of.
    VkDevice device = VK_NULL_HANDLE;                   ///< The logical device.
    VkQueue queue = VK_NULL_HANDLE;                     ///< That submits what is recorded.
    std::uint32_t queue_family = 0;                     ///< Of the queue.
};

/// What a host puts into descriptor sets of its own to sample a texture of Aureole's. Owned by the device and valid until the
/// texture is destroyed (and its last frame collected); a texture that the host lent stays the host's.
struct NativeTexture {
    VkImage image = VK_NULL_HANDLE;  ///< The texture's.
    /// All of it, as shaders declare it (2D, 3D, cube); null if the texture was made without rhi::Usage::sampled.
    VkImageView sampled_view = VK_NULL_HANDLE;
    /// The layout that the image has in rhi::State::sampled, for VkDescriptorImageInfo::imageLayout. The barrier into that
    /// state lets compute and (on a queue with graphics) fragment shaders read what was written before; other stages need a
    /// barrier of the host's. The next barrier out of it waits for those two stages.
    VkImageLayout sampled_layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// A headless device with instance, VkDevice and queue of its own. Destroying it waits for its work and frees everything
/// made from it.
class VulkanDevice {
public:
    virtual ~VulkanDevice() = default;
    [[nodiscard]] virtual rhi::Device& device() = 0;          ///< For Atmosphere and textures.
    [[nodiscard]] virtual rhi::Queue& queue() = 0;            ///< Records and runs command lists.
    [[nodiscard]] virtual VulkanHandles handles() const = 0;  ///< For a program that uses the device beside Aureole.

    /// The objects behind a handle of this device, for descriptor sets of the caller's own. Error(invalid_argument) for a null,
    /// unknown or destroyed handle.
    [[nodiscard]] virtual NativeTexture native(rhi::Texture texture) const = 0;
    /// The same for a buffer; bind the whole of it. rhi::State::constants makes it readable as the text above says of textures.
    [[nodiscard]] virtual VkBuffer native(rhi::Buffer buffer) const = 0;
};

/// Throws Error: unsupported (no Vulkan, no matching or no usable device, no validation layer; the text says why),
/// invalid_argument (index), out_of_memory. If several devices were tried, the text tells each one's reason, and the code is
/// that of the first.
[[nodiscard]] std::unique_ptr<VulkanDevice> create_vulkan_device(const VulkanDeviceDesc& desc);

/// A host's device. Everything stays the host's and must outlive the guest.
struct BorrowedVulkan {
    VkInstance instance = VK_NULL_HANDLE;               ///< Of Vulkan 1.1 at least.
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;  ///< That the device was made of.
    VkDevice device = VK_NULL_HANDLE;                   ///< The logical device.
    /// The entry point with which the host made `instance`; functions are looked up through it alone.
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    /// VkApplicationInfo::apiVersion of the instance: at least VK_API_VERSION_1_1.
    std::uint32_t api_version = 0;
    /// Family of the queue that the host submits to: with VK_QUEUE_COMPUTE_BIT; VK_QUEUE_GRAPHICS_BIT too for raster passes.
    std::uint32_t queue_family = 0;
    /// Another family, with VK_QUEUE_COMPUTE_BIT, whose queues get recordings too, or use what Aureole makes: asynchronous
    /// compute. Images and buffers are then made for both (VK_SHARING_MODE_CONCURRENT), so that nothing has to change hands;
    /// images that the host lends to recordings on both are to be so as well. Queues of one family need no such thing.
    /// VK_QUEUE_FAMILY_IGNORED or `queue_family`: there is none.
    std::uint32_t second_queue_family = VK_QUEUE_FAMILY_IGNORED;
    /// As enabled in VkDeviceCreateInfo: shaderStorageImageWriteWithoutFormat must be among them.
    VkPhysicalDeviceFeatures enabled_features = {};
    /// VK_EXT_debug_utils is enabled in `instance`: objects get names, passes get markers.
    bool debug_utils = false;
    /// Used for every pipeline if given; else the guest makes one.
    VkPipelineCache pipeline_cache = VK_NULL_HANDLE;
};

/// Aureole as a guest on a host's device. It makes objects, records into the host's command buffers, and never submits,
/// waits, or changes the host's objects. Destroying it frees everything made from it at once: the host has waited for the
/// device before.
class BorrowedVulkanDevice {
public:
    virtual ~BorrowedVulkanDevice() = default;
    [[nodiscard]] virtual rhi::Device& device() = 0;  ///< For Atmosphere and textures.

    /// Starts one recording into a command buffer of the host, which is in the recording state, outside of a render pass,
    /// primary, and goes to a queue of `queue_family`: BorrowedVulkan's, where that is VK_QUEUE_FAMILY_IGNORED, or its second
    /// one. Valid until `end_recording`; a recording that was
    /// not ended is forgotten as it is, and reported. Recording allocates nothing. Pipelines, descriptor sets, push constants,
    /// viewport and scissor that the host had bound are undefined afterwards. Command buffers run in the order in which they
    /// were recorded: on one queue as they are submitted, on several by semaphores of the host's from each to the next that
    /// uses the same tables, in both directions. On a family without graphics there are no raster passes and no copies of
    /// depth, on one without timestamps none of those: both are reported and left out. Error(invalid_argument) for a null
    /// command buffer or another family.
    [[nodiscard]] virtual rhi::CommandList& begin_recording(VkCommandBuffer commands,
                                                            std::uint32_t queue_family = VK_QUEUE_FAMILY_IGNORED) = 0;
    /// Ends the recording: textures lent with rhi::Device::wrap_texture that are not in the state they were lent in are
    /// returned to it, those destroyed since begin_recording included; open debug markers are closed. The command buffer stays
    /// in the recording state. Never throws.
    virtual void end_recording() noexcept = 0;

    /// The objects behind a handle of this device, for descriptor sets of the host's own. Error(invalid_argument) for a null,
    /// unknown or destroyed handle.
    [[nodiscard]] virtual NativeTexture native(rhi::Texture texture) const = 0;
    /// The same for a buffer; bind the whole of it. rhi::State::constants makes it readable as the text above says of textures.
    [[nodiscard]] virtual VkBuffer native(rhi::Buffer buffer) const = 0;
};

/// Throws Error: invalid_argument (a null handle, an unknown queue family), unsupported (api_version, a queue without
/// compute, a missing feature or entry point, each by name), out_of_memory. The host's device is then as it was.
[[nodiscard]] std::unique_ptr<BorrowedVulkanDevice> borrow_vulkan_device(const BorrowedVulkan& host);

}  // namespace aureole::vulkan
