#include "host_vulkan/resources.h"

#include <cstring>

namespace host_vulkan {

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const Use& before, const Use& after) {
    auto move = info_of<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    move.srcStageMask = before.stages;
    move.srcAccessMask = before.access;
    move.dstStageMask = after.stages;
    move.dstAccessMask = after.access;
    move.oldLayout = before.layout;
    move.newLayout = after.layout;
    move.srcQueueFamilyIndex = move.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    move.image = image;
    move.subresourceRange = {aspect, 0, 1, 0, 1};
    auto info = info_of<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &move;
    vkCmdPipelineBarrier2(commands, &info);
}

Image::Image(const Device& device, VkFormat format, VkExtent2D size, VkImageUsageFlags usage, bool shared)
    : extent(size),
      device_(device.handle),
      aspect_(format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT) {
    auto info = info_of<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {size.width, size.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    const std::uint32_t families[] = {device.family, device.compute_family};
    if (shared && families[0] != families[1]) {
        info.sharingMode = VK_SHARING_MODE_CONCURRENT;
        info.queueFamilyIndexCount = 2;
        info.pQueueFamilyIndices = families;
    }
    check(vkCreateImage(device_, &info, nullptr, &image), "vkCreateImage");
    VkMemoryRequirements need = {};
    vkGetImageMemoryRequirements(device_, image, &need);
    auto memory = info_of<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    memory.allocationSize = need.size;
    memory.memoryTypeIndex = device.memory_type(need.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkAllocateMemory(device_, &memory, nullptr, &memory_), "vkAllocateMemory");
    check(vkBindImageMemory(device_, image, memory_, 0), "vkBindImageMemory");
    auto whole = info_of<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    whole.image = image;
    whole.viewType = VK_IMAGE_VIEW_TYPE_2D;
    whole.format = format;
    whole.subresourceRange = {aspect_, 0, 1, 0, 1};
    check(vkCreateImageView(device_, &whole, nullptr, &view), "vkCreateImageView");
}

Image::~Image() {
    vkDestroyImageView(device_, view, nullptr);
    vkDestroyImage(device_, image, nullptr);
    vkFreeMemory(device_, memory_, nullptr);
}

void Image::move(VkCommandBuffer commands, const Use& next, bool keep) {
    Use before = last_;
    if (!keep) before.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier(commands, image, aspect_, before, next);
    last_ = next;
}

Buffer::Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, bool mapped) : device_(device.handle) {
    auto info = info_of<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = size;
    info.usage = usage;
    check(vkCreateBuffer(device_, &info, nullptr, &buffer), "vkCreateBuffer");
    VkMemoryRequirements need = {};
    vkGetBufferMemoryRequirements(device_, buffer, &need);
    constexpr VkMemoryPropertyFlags seen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    constexpr VkMemoryPropertyFlags kept = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    auto memory = info_of<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    memory.allocationSize = need.size;
    memory.memoryTypeIndex = device.memory_type(need.memoryTypeBits, mapped ? seen : kept);
    check(vkAllocateMemory(device_, &memory, nullptr, &memory_), "vkAllocateMemory");
    check(vkBindBufferMemory(device_, buffer, memory_, 0), "vkBindBufferMemory");
    if (!mapped) return;
    void* data = nullptr;
    check(vkMapMemory(device_, memory_, 0, VK_WHOLE_SIZE, 0, &data), "vkMapMemory");
    bytes = {static_cast<std::byte*>(data), static_cast<std::size_t>(size)};
}

Buffer::~Buffer() {
    vkDestroyBuffer(device_, buffer, nullptr);
    vkFreeMemory(device_, memory_, nullptr);
}

void upload(const Device& device, const Buffer& buffer, std::span<const std::byte> contents) {
    const Buffer staging(device, contents.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, true);
    std::memcpy(staging.bytes.data(), contents.data(), contents.size());
    auto pool_info = info_of<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool_info.queueFamilyIndex = device.family;
    VkCommandPool pool = VK_NULL_HANDLE;
    check(vkCreateCommandPool(device.handle, &pool_info, nullptr, &pool), "vkCreateCommandPool");
    auto allocate = info_of<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device.handle, &allocate, &commands), "vkAllocateCommandBuffers");
    auto begin = info_of<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    const VkBufferCopy whole = {0, 0, contents.size()};
    vkCmdCopyBuffer(commands, staging.buffer, buffer.buffer, 1, &whole);
    auto readable = info_of<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    readable.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    readable.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1, &readable, 0,
                         nullptr, 0, nullptr);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    auto submit = info_of<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(device.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(device.queue), "vkQueueWaitIdle");
    vkDestroyCommandPool(device.handle, pool, nullptr);
}

}  // namespace host_vulkan
