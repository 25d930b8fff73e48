// A host with a Vulkan device of its own, made with the functions that libvulkan exports: that this program links, and that
// they still work beside the backend, is part of what is tested.
#pragma once

#include "test_support.h"

#include <vulkan/vulkan.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace aureole::vulkan::test {

struct HostImage {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  ///< As the host believes it to be.
    std::uint32_t layers = 1;
};

/// A buffer that the CPU sees.
struct HostBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::span<std::byte> bytes{};
};

class Host {
public:
    explicit Host(bool validation = true);
    /// What the guest left behind, and everything else that the layer found, is a failure.
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    [[nodiscard]] BorrowedVulkan lend() const;
    [[nodiscard]] VkDevice device() const { return device_; }
    [[nodiscard]] VkPipelineCache make_pipeline_cache();

    /// An image with memory, destroyed with the host. Cube: six layers.
    HostImage& make_image(VkImageCreateInfo info, VkImageAspectFlags aspect);
    HostImage& make_image_2d(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage);

    /// A mapped buffer, destroyed with the host.
    HostBuffer& make_buffer(VkDeviceSize size, VkBufferUsageFlags usage);

    /// Recording: `commands()` begins a command buffer if there is none.
    VkCommandBuffer commands();
    void submit_and_wait();
    /// Everything before is done, everything after sees it.
    void move(HostImage& image, VkImageLayout layout);
    void clear_color(HostImage& image, float r, float g, float b, float a);
    void clear_depth(HostImage& image, float depth);
    /// What shaders wrote so far may be read by the CPU after submit_and_wait.
    void publish_shader_writes();
    /// The first `bytes` bytes of an image's first layer, after everything recorded so far.
    std::vector<std::byte> read(HostImage& image, VkExtent3D extent, std::size_t bytes);

    Messages messages;

private:
    VkInstance instance_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkPipelineCache pipeline_cache_ = VK_NULL_HANDLE;
    HostBuffer* staging_ = nullptr;
    bool recording_ = false, validation_ = false;
    std::unique_ptr<Messenger> messenger_;
    std::vector<std::unique_ptr<HostImage>> images_;
    std::vector<std::unique_ptr<HostBuffer>> buffers_;

    void publish(VkPipelineStageFlags stage, VkAccessFlags writes);
    [[nodiscard]] std::uint32_t memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;
};

}  // namespace aureole::vulkan::test
