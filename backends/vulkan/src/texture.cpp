#include "texture.h"

#include "formats.h"
#include "result.h"

#include <algorithm>
#include <string>

namespace aureole::vulkan {

TextureObject::TextureObject(Context& context, RenderPasses& passes, const rhi::TextureDesc& desc)
    : context_(context), desc_(desc) {
    try {
        create_image();
        create_views(VK_NULL_HANDLE);
        create_framebuffer(passes);
    } catch (...) {
        release();
        throw;
    }
    context_.set_name(VK_OBJECT_TYPE_IMAGE, image_, desc_.name);
}

TextureObject::TextureObject(Context& context, RenderPasses& passes, const rhi::ExternalTexture& external)
    : context_(context), desc_(external.desc), lent_(true), lent_state_(external.state) {
    if (external.native == 0)
        throw Error(ErrorCode::invalid_argument, rhi::field_name("texture", desc_.name, "native"), "0", "a VkImage");
    image_ = reinterpret_cast<VkImage>(external.native);
    try {
        create_views(reinterpret_cast<VkImageView>(external.native_view));
        create_framebuffer(passes);
    } catch (...) {
        release();
        throw;
    }
    start_recording();
}

TextureObject::~TextureObject() { release(); }

void TextureObject::release() noexcept {
    const auto& fn = context_.fn;
    fn.vkDestroyFramebuffer(context_.device, framebuffer_, nullptr);
    for (VkImageView view : {sampled_view_, storage_view_, target_view_})
        if (view != native_view_) fn.vkDestroyImageView(context_.device, view, nullptr);
    if (!lent_) fn.vkDestroyImage(context_.device, image_, nullptr);
    context_.memory.free(allocation_);
}

void TextureObject::create_image() {
    const std::string what = rhi::field_name("texture", desc_.name, "");
    const VkImageUsageFlags usage = image_usage(desc_.usage);
    const VkImageFormatProperties limits =
        image_limits(context_.instance_functions, context_.physical.handle, desc_.format, desc_.dimension, usage);
    if (limits.maxExtent.width == 0)
        throw Error(ErrorCode::unsupported, rhi::field_name("texture", desc_.name, "usage"), rhi::to_string(desc_.usage),
                    std::string("uses that the device combines for ") + rhi::to_string(desc_.format) + " (" +
                        rhi::to_string(desc_.dimension) + ")");
    if (rhi::packed_size(desc_) > limits.maxResourceSize)
        throw Error(ErrorCode::unsupported, rhi::field_name("texture", desc_.name, "extent"),
                    std::to_string(rhi::packed_size(desc_)) + " bytes",
                    "at most " + std::to_string(limits.maxResourceSize) + " bytes");

    VkImageCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.flags = image_flags(desc_.dimension);
    info.imageType = image_type(desc_.dimension);
    info.format = to_vulkan(desc_.format);
    info.extent = extent();
    info.mipLevels = 1;
    info.arrayLayers = layer_count(desc_.dimension);
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    context_.share(info);
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    check_result(context_.fn.vkCreateImage(context_.device, &info, nullptr, &image_), "vkCreateImage", what);

    VkMemoryRequirements need = {};
    context_.fn.vkGetImageMemoryRequirements(context_.device, image_, &need);
    allocation_ = context_.memory.allocate(need, MemoryUse::device, MemoryLayout::image, what);
    check_result(context_.fn.vkBindImageMemory(context_.device, image_, allocation_.memory, allocation_.offset),
                 "vkBindImageMemory", what);
}

/// The view types that the shaders declare: a cube is sampled as a cube and written as an array of six layers.
void TextureObject::create_views(VkImageView native_view) {
    native_view_ = native_view;
    const auto view = [&](VkImageViewType type, VkImageUsageFlags usage) {
        return native_view_ ? native_view_ : create_view(type, usage);
    };
    const VkImageViewType flat = desc_.dimension == rhi::Dimension::d3 ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
    const bool cube = desc_.dimension == rhi::Dimension::cube;
    if (has(desc_.usage, rhi::Usage::sampled))
        sampled_view_ = view(cube ? VK_IMAGE_VIEW_TYPE_CUBE : flat, VK_IMAGE_USAGE_SAMPLED_BIT);
    // One view of the host's cannot be both a cube and an array.
    if (has(desc_.usage, rhi::Usage::storage))
        storage_view_ = cube ? create_view(VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_USAGE_STORAGE_BIT)
                             : view(flat, VK_IMAGE_USAGE_STORAGE_BIT);
    if (has(desc_.usage, rhi::Usage::color_attachment)) target_view_ = view(flat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
}

VkImageView TextureObject::create_view(VkImageViewType type, VkImageUsageFlags usage) {
    VkImageViewUsageCreateInfo use = {};
    use.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_USAGE_CREATE_INFO;
    use.usage = usage;
    VkImageViewCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.pNext = &use;
    info.image = image_;
    info.viewType = type;
    info.format = to_vulkan(desc_.format);
    info.subresourceRange = whole();
    VkImageView view = VK_NULL_HANDLE;
    check_result(context_.fn.vkCreateImageView(context_.device, &info, nullptr, &view), "vkCreateImageView",
                 rhi::field_name("texture", desc_.name, ""));
    return view;
}

void TextureObject::create_framebuffer(RenderPasses& passes) {
    if (!target_view_) return;
    const VkPhysicalDeviceLimits& limits = context_.limits();
    const std::uint32_t width = std::min(limits.maxFramebufferWidth, limits.maxViewportDimensions[0]);
    const std::uint32_t height = std::min(limits.maxFramebufferHeight, limits.maxViewportDimensions[1]);
    if (desc_.extent.width > width || desc_.extent.height > height)
        throw Error(ErrorCode::unsupported, rhi::field_name("texture", desc_.name, "extent"),
                    std::to_string(desc_.extent.width) + "x" + std::to_string(desc_.extent.height),
                    "at most " + std::to_string(width) + "x" + std::to_string(height) + " for color_attachment");
    VkFramebufferCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = passes.get(desc_.format);
    info.attachmentCount = 1;
    info.pAttachments = &target_view_;
    info.width = desc_.extent.width;
    info.height = desc_.extent.height;
    info.layers = 1;
    check_result(context_.fn.vkCreateFramebuffer(context_.device, &info, nullptr, &framebuffer_), "vkCreateFramebuffer",
                 rhi::field_name("texture", desc_.name, ""));
}

void TextureObject::start_recording() noexcept {
    if (!lent_) return;
    last_state = lent_state_;
    last_access =
        lent_state_ == rhi::State::undefined ? unknown_access() : access_of(lent_state_, context_.graphics, read_layout());
}

VkImageLayout TextureObject::read_layout() const noexcept {
    const bool host_reads_depth = lent_ && lent_state_ == rhi::State::depth_read;
    return host_reads_depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

VkImageAspectFlags TextureObject::aspect() const noexcept { return aspect_of(desc_.format); }

VkExtent3D TextureObject::extent() const noexcept { return {desc_.extent.width, desc_.extent.height, desc_.extent.depth}; }

VkImageSubresourceRange TextureObject::whole() const noexcept { return {aspect(), 0, 1, 0, layer_count(desc_.dimension)}; }

VkImageSubresourceLayers TextureObject::layers() const noexcept { return {aspect(), 0, 0, layer_count(desc_.dimension)}; }

}  // namespace aureole::vulkan
