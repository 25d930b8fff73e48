#include "viewer/ui/gpu.h"

namespace aureole::viewer {
namespace {

VkDeviceMemory allocate(Gpu& gpu, const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties) {
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = gpu.memory_type(needs.memoryTypeBits, properties);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(vkAllocateMemory(gpu.device, &info, nullptr, &memory), "vkAllocateMemory");
    return memory;
}

}  // namespace

GpuImage::GpuImage(Gpu& gpu, VkExtent2D extent_in, VkImageUsageFlags usage) : extent(extent_in), gpu_(gpu) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = gpu.image_format;
    if (info.format != view_format) info.flags = VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    try {
        check(vkCreateImage(gpu.device, &info, nullptr, &image), "vkCreateImage");
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(gpu.device, image, &needs);
        memory_ = allocate(gpu, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
        check(vkBindImageMemory(gpu.device, image, memory_, 0), "vkBindImageMemory");
        if (!(usage & VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT)) return;
        VkImageViewCreateInfo view_info{};
        view_info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        view_info.image = image;
        view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view_info.format = view_format;
        view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        check(vkCreateImageView(gpu.device, &view_info, nullptr, &view), "vkCreateImageView");
    } catch (...) {
        destroy();
        throw;
    }
}

GpuImage::~GpuImage() { destroy(); }

void GpuImage::destroy() noexcept {
    vkDestroyImageView(gpu_.device, view, nullptr);
    vkDestroyImage(gpu_.device, image, nullptr);
    vkFreeMemory(gpu_.device, memory_, nullptr);
}

GpuBuffer::GpuBuffer(Gpu& gpu, std::size_t size, VkBufferUsageFlags usage) : gpu_(gpu) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    try {
        check(vkCreateBuffer(gpu.device, &info, nullptr, &buffer), "vkCreateBuffer");
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(gpu.device, buffer, &needs);
        memory_ = allocate(gpu, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        check(vkBindBufferMemory(gpu.device, buffer, memory_, 0), "vkBindBufferMemory");
        void* mapped = nullptr;
        check(vkMapMemory(gpu.device, memory_, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
        bytes = {static_cast<std::byte*>(mapped), size};
    } catch (...) {
        destroy();
        throw;
    }
}

GpuBuffer::~GpuBuffer() { destroy(); }

void GpuBuffer::destroy() noexcept {
    vkDestroyBuffer(gpu_.device, buffer, nullptr);
    vkFreeMemory(gpu_.device, memory_, nullptr);  // unmaps
}

void move(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0,
                         nullptr, 1, &barrier);
}

}  // namespace aureole::viewer
