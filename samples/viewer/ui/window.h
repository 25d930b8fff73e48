// A GLFW window with a Dear ImGui context, and input from people or from scripts.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace aureole::viewer {

/// Throws Error(unsupported) where there is no display.
class Window {
public:
    Window(std::uint32_t width, std::uint32_t height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] GLFWwindow* handle() const noexcept { return window_; }
    [[nodiscard]] bool wants_to_close() const;
    /// Pixels; 0 x 0 while it is minimized.
    [[nodiscard]] VkExtent2D size() const;
    /// Error(invalid_argument) below 200 x 100 or above 16384.
    void resize(int width, int height);
    /// What people have done; waits for it up to so many seconds.
    void poll(double seconds);

private:
    GLFWwindow* window_ = nullptr;
};

/// What a script does with mouse and keys: laid over the window's own input, before ImGui looks at it.
class ScriptedInput {
public:
    void mouse(double x, double y) { mouse_ = {static_cast<float>(x), static_cast<float>(y)}; }
    void button(int index, bool down) { buttons_[index] = down; }
    void wheel(double steps) { wheel_ += static_cast<float>(steps); }
    /// "a" to "z", "0" to "9", "space", "enter", "escape", "tab", "backspace", "delete", "left", "right", "up", "down",
    /// "shift", "ctrl". Throws Error(invalid_argument).
    void key(const std::string& name, bool down);
    void type(const std::string& text) { text_ += text; }
    /// Between the platform's and ImGui's NewFrame.
    void apply();

private:
    struct Point {
        float x, y;
    };
    std::optional<Point> mouse_;
    std::map<int, bool> buttons_, keys_;
    std::string text_;
    float wheel_ = 0;
};

}  // namespace aureole::viewer
