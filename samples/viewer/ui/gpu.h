// The window's own Vulkan device, and the little objects that are made on it. The panes have devices of their own.
#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>

struct GLFWwindow;

namespace aureole::viewer {

/// Throws Error(internal), or device_lost or out_of_memory, naming the call.
void check(VkResult result, const char* call);

struct GpuOptions {
    bool validation = false;
    bool srgb_surface = false;  ///< A format of the surface that encodes by itself, though there may be others.
};

/// Instance, surface, device with one queue that draws and presents. Everything of it must be gone before it.
class Gpu {
public:
    /// Throws Error(unsupported) where there is no such device, or no validation layer where that is asked for.
    Gpu(GLFWwindow* window, const GpuOptions& options);
    ~Gpu();
    Gpu(const Gpu&) = delete;
    Gpu& operator=(const Gpu&) = delete;

    /// Records, submits, waits.
    void run(const std::function<void(VkCommandBuffer)>& record) const;
    [[nodiscard]] std::uint32_t memory_type(std::uint32_t bits, VkMemoryPropertyFlags properties) const;
    /// Warnings and errors of the validation layer.
    [[nodiscard]] int findings() const noexcept { return findings_; }

    VkInstance instance = VK_NULL_HANDLE;
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkSurfaceFormatKHR surface_format{};
    /// Of images on their way to the surface. Their bytes are encoded already, and blits convert between formats: what is
    /// blitted into a surface that encodes must be called encoded, too.
    VkFormat image_format = VK_FORMAT_UNDEFINED;

private:
    void make_instance(bool validation);
    void choose_device();
    void choose_format(bool srgb);
    void make_device();
    void destroy() noexcept;
    static VkBool32 VKAPI_PTR on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::atomic<int> findings_ = 0;
};

/// An image of Gpu::image_format with its memory, and a view of its bytes as they are (`view_format`).
class GpuImage {
public:
    GpuImage(Gpu& gpu, VkExtent2D extent, VkImageUsageFlags usage);
    ~GpuImage();
    GpuImage(const GpuImage&) = delete;
    GpuImage& operator=(const GpuImage&) = delete;

    static constexpr VkFormat view_format = VK_FORMAT_R8G8B8A8_UNORM;
    VkExtent2D extent;
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;

private:
    void destroy() noexcept;
    Gpu& gpu_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// A buffer that the processor reads or writes, mapped while it lives.
class GpuBuffer {
public:
    GpuBuffer(Gpu& gpu, std::size_t size, VkBufferUsageFlags usage);
    ~GpuBuffer();
    GpuBuffer(const GpuBuffer&) = delete;
    GpuBuffer& operator=(const GpuBuffer&) = delete;

    VkBuffer buffer = VK_NULL_HANDLE;
    std::span<std::byte> bytes;

private:
    void destroy() noexcept;
    Gpu& gpu_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// Moves an image's one mip level from layout to layout, behind all that was done and before all that is done: this window has
/// nothing to gain from less.
void move(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to);

}  // namespace aureole::viewer
