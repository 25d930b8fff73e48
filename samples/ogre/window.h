// The window and its OpenGL context, which the engine and Aureole share.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct GLFWwindow;

namespace aureole::ogre {

/// What the user has asked for since the last frame.
struct Steering {
    double turn_right = 0, turn_up = 0;           ///< Radians.
    double forward_m = 0, right_m = 0, up_m = 0;  ///< Along the camera's axes.
    double sun_higher_deg = 0, sun_clockwise_deg = 0;
    double stops = 0;  ///< Of exposure.
    bool quit = false;
};

class Window {
public:
    /// A debug context of OpenGL 4.3, core profile, current in this thread. Throws Error(unsupported) where there is none.
    Window(std::uint32_t width, std::uint32_t height, bool visible);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Starts to listen to the driver: once whoever else does so (an engine) is set up.
    void listen();
    /// Errors and undefined behaviour that the driver has told of, a line each; forgets them.
    [[nodiscard]] std::string take_messages();

    void swap();
    [[nodiscard]] Steering steer();

private:
    [[nodiscard]] bool pressed(int key) const;

    GLFWwindow* window_ = nullptr;
    std::string messages_;
    double last_time_ = 0, last_x_ = 0, last_y_ = 0;
};

}  // namespace aureole::ogre
