#include "host_vulkan/swapchain.h"

#include "common/surface.h"

#include <limits>

namespace host_vulkan {
namespace {

/// 8 bits that the display pass encodes itself, where there are any.
VkSurfaceFormatKHR choose_format(const Device& device) {
    if (const auto found = aureole::app::surface_format(device.physical, device.surface, false)) return *found;
    throw std::runtime_error("the window takes no sRGB of 8 bits");
}

}  // namespace

Swapchain::Swapchain(const Device& device, VkExtent2D size, const Swapchain* old)
    : device_(device), format_(choose_format(device)) {
    VkSurfaceCapabilitiesKHR can = {};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physical, device.surface, &can), "surface capabilities");
    extent_ = aureole::app::surface_extent(can, size);
    copied_ = can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    auto info = info_of<VkSwapchainCreateInfoKHR>(VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR);
    info.surface = device.surface;
    info.minImageCount = aureole::app::surface_images(can);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | (copied_ ? VkImageUsageFlags{VK_IMAGE_USAGE_TRANSFER_SRC_BIT} : 0);
    info.preTransform = can.currentTransform;
    info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = old ? old->handle_ : VK_NULL_HANDLE;
    check(vkCreateSwapchainKHR(device.handle, &info, nullptr, &handle_), "vkCreateSwapchainKHR");

    std::uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(device.handle, handle_, &count, nullptr), "vkGetSwapchainImagesKHR");
    std::vector<VkImage> images(count);
    check(vkGetSwapchainImagesKHR(device.handle, handle_, &count, images.data()), "vkGetSwapchainImagesKHR");
    for (const VkImage image : images) {
        Target& target = targets_.emplace_back(Target{image, VK_NULL_HANDLE, VK_NULL_HANDLE});
        auto view = info_of<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
        view.image = image;
        view.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view.format = format_.format;
        view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        check(vkCreateImageView(device.handle, &view, nullptr, &target.view), "vkCreateImageView");
        const auto semaphore = info_of<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
        check(vkCreateSemaphore(device.handle, &semaphore, nullptr, &target.rendered), "vkCreateSemaphore");
    }
}

bool Swapchain::encodes() const noexcept { return aureole::app::encodes_srgb(format_.format); }

Swapchain::~Swapchain() {
    for (const Target& target : targets_) {
        vkDestroyImageView(device_.handle, target.view, nullptr);
        vkDestroySemaphore(device_.handle, target.rendered, nullptr);
    }
    vkDestroySwapchainKHR(device_.handle, handle_, nullptr);
}

std::optional<std::uint32_t> Swapchain::acquire(VkSemaphore acquired) {
    std::uint32_t index = 0;
    const VkResult result = vkAcquireNextImageKHR(device_.handle, handle_, std::numeric_limits<std::uint64_t>::max(), acquired,
                                                  VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return {};
    check(result, "vkAcquireNextImageKHR");
    return index;
}

bool Swapchain::present(std::uint32_t index) {
    auto info = info_of<VkPresentInfoKHR>(VK_STRUCTURE_TYPE_PRESENT_INFO_KHR);
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &targets_[index].rendered;
    info.swapchainCount = 1;
    info.pSwapchains = &handle_;
    info.pImageIndices = &index;
    const VkResult result = vkQueuePresentKHR(device_.queue, &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    check(result, "vkQueuePresentKHR");
    return true;
}

}  // namespace host_vulkan
