// Cascaded shadow maps of the first sun: where they lie. Aureole takes the same map and the same matrices.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace host_vulkan {

struct Cascades {
    static constexpr std::uint32_t count = 3, side = 1024;  ///< Side by side in one image, the finest first.

    /// From metres from the camera (world axes) to u and v in [0, 1] across each cascade, and depth in [0, 1], 1 the farthest.
    std::array<glm::dmat4, count> camera_to_map{};
    std::array<double, count> texel_m{};
    double depth_m = 1;  ///< What a depth of 1 is.
};

/// Around the camera: the last one reaches `reach_m` to all sides, each finer one a third as far. `towards_sun`: unit vector.
[[nodiscard]] Cascades cascades_around(const glm::dvec3& camera_m, const glm::dvec3& towards_sun, double reach_m);

}  // namespace host_vulkan
