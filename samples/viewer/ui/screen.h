// What a frame of the window is made of: the panes' picture, the widgets over it, and a way to keep the result.
#pragma once

#include "io/image.h"
#include "viewer/ui/swapchain.h"

#include <memory>
#include <optional>

namespace aureole::viewer {

/// A rectangle of the window, pixels.
struct Area {
    std::int32_t x = 0, y = 0;
    std::uint32_t width = 0, height = 0;
};

/// Dear ImGui's context exists, with GLFW's part, before a Screen is made, and outlives it.
class Screen {
public:
    Screen(Gpu& gpu, VkExtent2D size);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// The next frame is for another size of the window.
    void resize(VkExtent2D size);
    /// Shown from the next frame on. 0 x 0: none.
    void set_picture(const app::DisplayImage& picture);
    /// One frame: the picture over the area, then ImGui's draw data (ImGui::Render was called).
    void show(const Area& area);
    /// The last frame.
    [[nodiscard]] app::DisplayImage screenshot();

private:
    void make_pass();
    void start_gui();
    void make_frame(VkExtent2D size);
    void draw(VkCommandBuffer commands, const Area& area);
    void draw_picture(VkCommandBuffer commands, const Area& area);

    Gpu& gpu_;
    VkRenderPass pass_ = VK_NULL_HANDLE;
    VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
    std::optional<Swapchain> swapchain_;
    std::unique_ptr<GpuImage> frame_, picture_;
    VkExtent2D wanted_;
    bool stale_ = false;  ///< Swapchain and frame are of another size than the window.
};

}  // namespace aureole::viewer
