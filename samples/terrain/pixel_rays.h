// Where the pixels of a perspective picture look, and what their depth is: for those who draw geometry on the CPU.
#pragma once

#include <aureole/camera.h>

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace aureole::app {

/// Rays through the middles of the pixels, rows from the top. The camera is one made by aureole::look.
struct PixelRays {
    glm::dmat3 to_world;
    double half_width, half_height;  // of the picture at view depth 1
    std::uint32_t width, height;

    PixelRays(const Camera& camera, std::uint32_t w, std::uint32_t h)
        : to_world(glm::transpose(glm::dmat3(camera.view))),
          half_width(1 / camera.projection[0][0]),
          half_height(1 / camera.projection[1][1]),
          width(w),
          height(h) {}

    /// Unit vector; -z of it is the view depth of a point at distance 1 along the ray.
    [[nodiscard]] glm::dvec3 in_view(std::uint32_t x, std::uint32_t y) const {
        return glm::normalize(
            glm::dvec3((2 * (x + 0.5) / width - 1) * half_width, (1 - 2 * (y + 0.5) / height) * half_height, -1));
    }
};

/// What a projection matrix writes into the depth buffer for a view depth.
[[nodiscard]] inline double depth_value(const glm::dmat4& projection, double view_depth) {
    return (-projection[2][2] * view_depth + projection[3][2]) / (-projection[2][3] * view_depth + projection[3][3]);
}

}  // namespace aureole::app
