#include "host_vulkan/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace host_vulkan {
namespace {

[[noreturn]] void fail(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw std::runtime_error(std::string(what) + ": " + (reason ? reason : "GLFW does not say why"));
}

/// Before the instance is made, which asks for the surface's extensions.
GLFWwindow* open(const std::string& title, VkExtent2D size) {
    if (!glfwInit()) fail("no window can be opened");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* window = nullptr;
    if (glfwVulkanSupported())
        window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title.c_str(), nullptr, nullptr);
    if (window) return window;
    glfwTerminate();
    fail("no window can be opened for Vulkan");
}

}  // namespace

Window::Window(const std::string& title, VkExtent2D size) : window_(open(title, size)) {}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::span<const char* const> Window::instance_extensions() {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (!names) fail("Vulkan cannot draw to windows here");
    return {names, count};
}

VkSurfaceKHR Window::make_surface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    check(glfwCreateWindowSurface(instance, window_, nullptr, &surface), "glfwCreateWindowSurface");
    return surface;
}

bool Window::poll() {
    glfwPollEvents();
    return !glfwWindowShouldClose(window_) && glfwGetKey(window_, GLFW_KEY_ESCAPE) != GLFW_PRESS;
}

VkExtent2D Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

void Window::resize(VkExtent2D wanted) {
    glfwSetWindowSize(window_, static_cast<int>(wanted.width), static_cast<int>(wanted.height));
    for (int wait = 0; wait < 20; ++wait) {
        const VkExtent2D now = size();
        if (now.width == wanted.width && now.height == wanted.height) return;
        glfwWaitEventsTimeout(0.05);
    }
}

Window::Turn Window::turn(double seconds) const {
    constexpr double deg_per_s = 30;
    const auto pressed = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS ? deg_per_s * seconds : 0.0; };
    return {pressed(GLFW_KEY_RIGHT) - pressed(GLFW_KEY_LEFT), pressed(GLFW_KEY_UP) - pressed(GLFW_KEY_DOWN)};
}

}  // namespace host_vulkan
