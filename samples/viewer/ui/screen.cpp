#include "viewer/ui/screen.h"

#include <aureole/rhi/error.h>

#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include <algorithm>

namespace aureole::viewer {
namespace {

constexpr VkImageUsageFlags frame_usage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

VkBufferImageCopy whole(VkExtent2D extent) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {extent.width, extent.height, 1};
    return copy;
}

}  // namespace

Screen::Screen(Gpu& gpu, VkExtent2D size) : gpu_(gpu), wanted_(size) {
    make_pass();
    start_gui();
    make_frame(size);
}

Screen::~Screen() {
    vkDeviceWaitIdle(gpu_.device);
    ImGui_ImplVulkan_Shutdown();
    vkDestroyFramebuffer(gpu_.device, framebuffer_, nullptr);
    vkDestroyDescriptorPool(gpu_.device, descriptors_, nullptr);
    vkDestroyRenderPass(gpu_.device, pass_, nullptr);
}

/// Widgets go over what is there.
void Screen::make_pass() {
    VkAttachmentDescription attachment{};
    attachment.format = GpuImage::view_format;
    attachment.samples = VK_SAMPLE_COUNT_1_BIT;
    attachment.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    attachment.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    attachment.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    attachment.initialLayout = attachment.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 1;
    info.pAttachments = &attachment;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    check(vkCreateRenderPass(gpu_.device, &info, nullptr, &pass_), "vkCreateRenderPass");
}

void Screen::start_gui() {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8};
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    pool.maxSets = 8;
    pool.poolSizeCount = 1;
    pool.pPoolSizes = &size;
    check(vkCreateDescriptorPool(gpu_.device, &pool, nullptr, &descriptors_), "vkCreateDescriptorPool");

    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = gpu_.instance;
    info.PhysicalDevice = gpu_.physical_device;
    info.Device = gpu_.device;
    info.QueueFamily = gpu_.family;
    info.Queue = gpu_.queue;
    info.DescriptorPool = descriptors_;
    info.MinImageCount = info.ImageCount = 2;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = [](VkResult result) { check(result, "Dear ImGui"); };
    ImGui_ImplVulkan_Init(&info, pass_);
    gpu_.run([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

void Screen::resize(VkExtent2D size) {
    wanted_ = size;
    stale_ = true;
}

void Screen::make_frame(VkExtent2D size) {
    vkDeviceWaitIdle(gpu_.device);
    vkDestroyFramebuffer(gpu_.device, framebuffer_, nullptr);
    framebuffer_ = VK_NULL_HANDLE;
    swapchain_.reset();
    swapchain_.emplace(gpu_, size);
    frame_ = std::make_unique<GpuImage>(gpu_, swapchain_->extent(), frame_usage);
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = pass_;
    info.attachmentCount = 1;
    info.pAttachments = &frame_->view;
    info.width = frame_->extent.width;
    info.height = frame_->extent.height;
    info.layers = 1;
    check(vkCreateFramebuffer(gpu_.device, &info, nullptr, &framebuffer_), "vkCreateFramebuffer");
}

void Screen::set_picture(const app::DisplayImage& picture) {
    const VkExtent2D extent{picture.width, picture.height};
    const bool fits = picture_ && picture_->extent.width == extent.width && picture_->extent.height == extent.height;
    if (!fits) picture_.reset();
    if (extent.width == 0) return;
    const bool fresh = !picture_;
    if (fresh)
        picture_ = std::make_unique<GpuImage>(gpu_, extent, VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    GpuBuffer upload(gpu_, std::size_t{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    for (std::size_t i = 0; i < std::size_t{extent.width} * extent.height; ++i) {
        for (std::size_t c = 0; c < 3; ++c) upload.bytes[4 * i + c] = static_cast<std::byte>(picture.rgb[3 * i + c]);
        upload.bytes[4 * i + 3] = std::byte{255};
    }
    gpu_.run([&](VkCommandBuffer commands) {
        move(commands, picture_->image, fresh ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkBufferImageCopy copy = whole(extent);
        vkCmdCopyBufferToImage(commands, upload.buffer, picture_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
        move(commands, picture_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    });
}

void Screen::show(const Area& area) {
    if (stale_) make_frame(wanted_);
    stale_ = !swapchain_->show(*frame_, [&](VkCommandBuffer commands) { draw(commands, area); });
}

void Screen::draw(VkCommandBuffer commands, const Area& area) {
    move(commands, frame_->image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearColorValue dark{{0, 0, 0, 1}};  // of which the format's curve makes nothing else
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, frame_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark, 1, &all);
    if (picture_ && area.width > 0 && area.height > 0) draw_picture(commands, area);
    move(commands, frame_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = pass_;
    begin.framebuffer = framebuffer_;
    begin.renderArea.extent = frame_->extent;
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
    vkCmdEndRenderPass(commands);
    move(commands, frame_->image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

/// Pixel for pixel where sizes agree; smaller pictures are interpolated.
void Screen::draw_picture(VkCommandBuffer commands, const Area& area) {
    // Clears and blits are both transfers: one after the other.
    move(commands, frame_->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const bool same = picture_->extent.width == area.width && picture_->extent.height == area.height;
    const auto right =
        std::min(area.x + static_cast<std::int32_t>(area.width), static_cast<std::int32_t>(frame_->extent.width));
    const auto bottom =
        std::min(area.y + static_cast<std::int32_t>(area.height), static_cast<std::int32_t>(frame_->extent.height));
    VkImageBlit region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<std::int32_t>(picture_->extent.width),
                            static_cast<std::int32_t>(picture_->extent.height), 1};
    region.dstOffsets[0] = {area.x, area.y, 0};
    region.dstOffsets[1] = {right, bottom, 1};
    vkCmdBlitImage(commands, picture_->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, frame_->image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, same ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
}

app::DisplayImage Screen::screenshot() {
    const VkExtent2D extent = frame_->extent;
    GpuBuffer buffer(gpu_, std::size_t{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    gpu_.run([&](VkCommandBuffer commands) {
        move(commands, frame_->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        const VkBufferImageCopy copy = whole(extent);
        vkCmdCopyImageToBuffer(commands, frame_->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.buffer, 1, &copy);
    });
    app::DisplayImage image{extent.width, extent.height, {}};
    image.rgb.resize(std::size_t{3} * extent.width * extent.height);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<std::uint8_t>(buffer.bytes[i / 3 * 4 + i % 3]);
    return image;
}

}  // namespace aureole::viewer
