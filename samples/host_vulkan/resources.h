// Images and buffers with memory, and what an image was last used for.
#pragma once

#include "host_vulkan/device.h"

#include <cstddef>
#include <span>

namespace host_vulkan {

/// How commands use an image.
struct Use {
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
};
namespace uses {
constexpr VkPipelineStageFlags2 shaders = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 depth_tests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr Use color_attachment = {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                  VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
constexpr Use depth_attachment = {
    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, depth_tests,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
/// Read by shaders, and by the depth test of what does not write depth.
constexpr Use depth_read = {VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL, shaders | depth_tests,
                            VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT};
constexpr Use sampled = {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, shaders, VK_ACCESS_2_SHADER_READ_BIT};
constexpr Use storage_write = {VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT};
constexpr Use copy_source = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr Use present = {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_NONE, 0};
}  // namespace uses

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const Use& before, const Use& after);

/// A 2D image of one level with memory and a view of all of it.
class Image {
public:
    /// `shared`: by the families of both queues.
    Image(const Device& device, VkFormat format, VkExtent2D size, VkImageUsageFlags usage, bool shared = false);
    ~Image();
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;

    /// For its next use; `keep` its contents or not. What was recorded before for it is over then, and seen.
    void move(VkCommandBuffer commands, const Use& next, bool keep);

    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    const VkExtent2D extent;

private:
    VkDevice device_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkImageAspectFlags aspect_;
    Use last_;
};

class Buffer {
public:
    /// In memory of the device, or mapped: coherent memory that the CPU sees.
    Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, bool mapped);
    ~Buffer();
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    VkBuffer buffer = VK_NULL_HANDLE;
    std::span<std::byte> bytes{};  ///< Of a mapped one.

private:
    VkDevice device_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// Fills a buffer of the device (with transfer-destination usage) and waits: for loading, not for frames.
void upload(const Device& device, const Buffer& buffer, std::span<const std::byte> contents);

}  // namespace host_vulkan
