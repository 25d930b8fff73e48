#include "window.h"

#include <aureole/rhi/error.h>
#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace aureole::ogre {
namespace {

[[noreturn]] void fail(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error(ErrorCode::unsupported, what + (reason ? ": " + std::string(reason) : ""));
}

void GLAPIENTRY hear(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* messages) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
        *static_cast<std::string*>(const_cast<void*>(messages)) += std::string(text) + "\n";
}

}  // namespace

Window::Window(std::uint32_t width, std::uint32_t height, bool visible) {
    if (!glfwInit()) fail("no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), "Aureole in OGRE", nullptr, nullptr);
    if (!window_) {
        glfwTerminate();
        fail("no window with an OpenGL 4.3 context");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(visible ? 1 : 0);
    last_time_ = glfwGetTime();
    glfwGetCursorPos(window_, &last_x_, &last_y_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::listen() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(hear, &messages_);
}

std::string Window::take_messages() { return std::exchange(messages_, {}); }

void Window::swap() { glfwSwapBuffers(window_); }

bool Window::pressed(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

Steering Window::steer() {
    glfwPollEvents();
    const double now = glfwGetTime(), passed = now - std::exchange(last_time_, now);
    double x = 0, y = 0;
    glfwGetCursorPos(window_, &x, &y);
    const double dx = x - std::exchange(last_x_, x), dy = y - std::exchange(last_y_, y);
    const auto axis = [&](int more, int less) { return passed * (pressed(more) - pressed(less)); };
    const double speed = pressed(GLFW_KEY_LEFT_SHIFT) ? 3000 : 200;  // m/s

    Steering steering;
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
        constexpr double radians_per_pixel = 0.002;
        steering.turn_right = dx * radians_per_pixel;
        steering.turn_up = -dy * radians_per_pixel;
    }
    steering.forward_m = speed * axis(GLFW_KEY_W, GLFW_KEY_S);
    steering.right_m = speed * axis(GLFW_KEY_D, GLFW_KEY_A);
    steering.up_m = speed * axis(GLFW_KEY_E, GLFW_KEY_Q);
    steering.sun_higher_deg = 10 * axis(GLFW_KEY_UP, GLFW_KEY_DOWN);
    steering.sun_clockwise_deg = 20 * axis(GLFW_KEY_RIGHT, GLFW_KEY_LEFT);
    steering.stops = 2 * axis(GLFW_KEY_PERIOD, GLFW_KEY_COMMA);
    steering.quit = glfwWindowShouldClose(window_) || pressed(GLFW_KEY_ESCAPE);
    return steering;
}

}  // namespace aureole::ogre
