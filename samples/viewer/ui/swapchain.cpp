#include "viewer/ui/swapchain.h"

#include "common/surface.h"

#include <aureole/rhi/error.h>

#include <limits>

namespace aureole::viewer {
namespace {

VkSemaphore make_semaphore(const Gpu& gpu) {
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    VkSemaphore semaphore = VK_NULL_HANDLE;
    check(vkCreateSemaphore(gpu.device, &info, nullptr, &semaphore), "vkCreateSemaphore");
    return semaphore;
}

void blit(VkCommandBuffer commands, const GpuImage& source, VkImage destination, VkExtent2D extent) {
    VkImageBlit region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<std::int32_t>(source.extent.width), static_cast<std::int32_t>(source.extent.height), 1};
    region.dstOffsets[1] = {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height), 1};
    vkCmdBlitImage(commands, source.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, destination,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_NEAREST);
}

}  // namespace

Swapchain::Swapchain(Gpu& gpu, VkExtent2D wanted) : gpu_(gpu) {
    try {
        make(wanted);
    } catch (...) {
        destroy();
        throw;
    }
}

Swapchain::~Swapchain() { destroy(); }

void Swapchain::make(VkExtent2D wanted) {
    VkSurfaceCapabilitiesKHR surface;
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(gpu_.physical_device, gpu_.surface, &surface),
          "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    if (!(surface.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT))
        throw Error(ErrorCode::unsupported, "the window's surface takes no blits");
    extent_ = app::surface_extent(surface, wanted);
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = gpu_.surface;
    info.minImageCount = app::surface_images(surface);
    info.imageFormat = gpu_.surface_format.format;
    info.imageColorSpace = gpu_.surface_format.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = surface.currentTransform;
    info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    check(vkCreateSwapchainKHR(gpu_.device, &info, nullptr, &swapchain_), "vkCreateSwapchainKHR");

    std::uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(gpu_.device, swapchain_, &count, nullptr), "vkGetSwapchainImagesKHR");
    images_.resize(count);
    check(vkGetSwapchainImagesKHR(gpu_.device, swapchain_, &count, images_.data()), "vkGetSwapchainImagesKHR");
    for (std::size_t i = 0; i < images_.size(); ++i) drawn_.push_back(make_semaphore(gpu_));
    acquired_ = make_semaphore(gpu_);
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    check(vkCreateFence(gpu_.device, &fence, nullptr, &done_), "vkCreateFence");
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = gpu_.pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(gpu_.device, &allocate, &commands_), "vkAllocateCommandBuffers");
}

void Swapchain::destroy() noexcept {
    vkQueueWaitIdle(gpu_.queue);
    if (commands_) vkFreeCommandBuffers(gpu_.device, gpu_.pool, 1, &commands_);
    vkDestroyFence(gpu_.device, done_, nullptr);
    vkDestroySemaphore(gpu_.device, acquired_, nullptr);
    for (const VkSemaphore semaphore : drawn_) vkDestroySemaphore(gpu_.device, semaphore, nullptr);
    vkDestroySwapchainKHR(gpu_.device, swapchain_, nullptr);
}

bool Swapchain::show(const GpuImage& source, const std::function<void(VkCommandBuffer)>& draw) {
    std::uint32_t index = 0;
    const VkResult acquired = vkAcquireNextImageKHR(gpu_.device, swapchain_, std::numeric_limits<std::uint64_t>::max(),
                                                    acquired_, VK_NULL_HANDLE, &index);
    if (acquired == VK_ERROR_OUT_OF_DATE_KHR) {
        gpu_.run(draw);
        return false;
    }
    check(acquired, "vkAcquireNextImageKHR");

    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
    draw(commands_);
    move(commands_, images_[index], VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    blit(commands_, source, images_[index], extent_);
    move(commands_, images_[index], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");

    const VkPipelineStageFlags everything = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.waitSemaphoreCount = 1;
    submit.pWaitSemaphores = &acquired_;
    submit.pWaitDstStageMask = &everything;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands_;
    submit.signalSemaphoreCount = 1;
    submit.pSignalSemaphores = &drawn_[index];
    check(vkQueueSubmit(gpu_.queue, 1, &submit, done_), "vkQueueSubmit");

    VkPresentInfoKHR present{};
    present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    present.waitSemaphoreCount = 1;
    present.pWaitSemaphores = &drawn_[index];
    present.swapchainCount = 1;
    present.pSwapchains = &swapchain_;
    present.pImageIndices = &index;
    const VkResult presented = vkQueuePresentKHR(gpu_.queue, &present);
    check(vkWaitForFences(gpu_.device, 1, &done_, VK_TRUE, std::numeric_limits<std::uint64_t>::max()), "vkWaitForFences");
    check(vkResetFences(gpu_.device, 1, &done_), "vkResetFences");
    if (presented != VK_ERROR_OUT_OF_DATE_KHR) check(presented, "vkQueuePresentKHR");
    return presented == VK_SUCCESS && acquired == VK_SUCCESS;
}

}  // namespace aureole::viewer
