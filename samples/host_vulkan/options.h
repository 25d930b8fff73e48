// The command line.
#pragma once

#include "host_vulkan/vulkan.h"

#include <filesystem>
#include <optional>

namespace host_vulkan {

struct Options {
    std::filesystem::path scene, screenshot;
    VkExtent2D size = {1280, 720};
    std::uint32_t frames = 0;  ///< 0: until the window is closed.
    std::uint32_t resize_every = 0;
    std::uint32_t frames_in_flight = 2;
    std::uint32_t spheres = 5;
    double sway_deg = 0;
    std::optional<double> exposure;
    bool async_compute = false;
    bool validate = false;
};

/// None if the program is to end at once with the exit code that is put into `code`: help, or a fault that was told.
[[nodiscard]] std::optional<Options> parse(int argc, char** argv, int& code);

}  // namespace host_vulkan
