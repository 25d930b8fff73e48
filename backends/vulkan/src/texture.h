// Textures: images with a view for each kind of use, and the framebuffer of those that are drawn to.
#pragma once

#include "context.h"
#include "render_pass.h"
#include "states.h"

#include <aureole/rhi/checks.h>

namespace aureole::vulkan {

class TextureObject {
public:
    /// `desc` has passed rhi::check. Throws Error and leaves nothing behind.
    TextureObject(Context& context, RenderPasses& passes, const rhi::TextureDesc& desc);
    /// A host's image; `external` has passed rhi::check. Throws Error.
    TextureObject(Context& context, RenderPasses& passes, const rhi::ExternalTexture& external);
    ~TextureObject();
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;

    [[nodiscard]] const rhi::TextureDesc& desc() const noexcept { return desc_; }
    [[nodiscard]] VkImage image() const noexcept { return image_; }
    /// Null where the usage does not allow it.
    [[nodiscard]] VkImageView sampled_view() const noexcept { return sampled_view_; }
    [[nodiscard]] VkImageView storage_view() const noexcept { return storage_view_; }
    [[nodiscard]] VkFramebuffer framebuffer() const noexcept { return framebuffer_; }

    [[nodiscard]] bool is_depth() const noexcept { return desc_.format == rhi::Format::d32_float; }
    [[nodiscard]] VkImageAspectFlags aspect() const noexcept;
    /// Layout while shaders read it: a host's depth texture that is lent in State::depth_read stays as the host has it.
    [[nodiscard]] VkImageLayout read_layout() const noexcept;
    [[nodiscard]] VkImageSubresourceRange whole() const noexcept;
    [[nodiscard]] VkImageSubresourceLayers layers() const noexcept;
    [[nodiscard]] VkExtent3D extent() const noexcept;

    /// What was done to it last, by the commands recorded so far; a barrier from State::undefined waits for that.
    StateAccess last_access;
    /// The state that the last barrier left it in.
    rhi::State last_state = rhi::State::undefined;
    /// A host's texture is returned to this state when a recording ends.
    [[nodiscard]] bool is_lent() const noexcept { return lent_; }
    [[nodiscard]] rhi::State lent_state() const noexcept { return lent_state_; }
    /// A recording starts: a host's texture is as the host lent it.
    void start_recording() noexcept;

private:
    void create_image();
    void create_views(VkImageView native_view);
    void create_framebuffer(RenderPasses& passes);
    [[nodiscard]] VkImageView create_view(VkImageViewType type, VkImageUsageFlags usage);
    void release() noexcept;

    Context& context_;
    rhi::TextureDesc desc_;
    bool lent_ = false;
    rhi::State lent_state_ = rhi::State::undefined;
    VkImage image_ = VK_NULL_HANDLE;
    Memory::Allocation allocation_;
    VkImageView sampled_view_ = VK_NULL_HANDLE, storage_view_ = VK_NULL_HANDLE, target_view_ = VK_NULL_HANDLE;
    VkImageView native_view_ = VK_NULL_HANDLE;  ///< The host's, never destroyed here.
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

}  // namespace aureole::vulkan
