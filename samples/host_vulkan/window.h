// A window of GLFW.
#pragma once

#include "host_vulkan/vulkan.h"

#include <span>
#include <string>

struct GLFWwindow;

namespace host_vulkan {

class Window {
public:
    /// Throws std::runtime_error where there is no display.
    Window(const std::string& title, VkExtent2D size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] static std::span<const char* const> instance_extensions();
    [[nodiscard]] VkSurfaceKHR make_surface(VkInstance instance) const;

    /// Handles what has come in. False once the window is to close.
    [[nodiscard]] bool poll();
    /// In pixels; 0 x 0 while it is minimized.
    [[nodiscard]] VkExtent2D size() const;
    /// Asks for another size and waits, a second at most, until the window has it.
    void resize(VkExtent2D wanted);
    /// How far keys ask to turn since the last call: right and up, degrees.
    struct Turn {
        double right_deg = 0, up_deg = 0;
    };
    [[nodiscard]] Turn turn(double seconds) const;

private:
    GLFWwindow* window_;
};

}  // namespace host_vulkan
