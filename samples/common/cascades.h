// Where the cascades of a light's shadow map lie, the finest first: as aureole::ShadowMap takes them (shadows.h).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace aureole::app {

/// The directions of a map's u and v.
struct LightAxes {
    explicit LightAxes(const glm::dvec3& towards_light)
        : across(glm::normalize(
              glm::cross(std::abs(towards_light.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0), towards_light))),
          along(glm::cross(towards_light, across)),
          towards(towards_light) {}

    glm::dvec3 across, along, towards;  ///< Unit vectors, world axes.
};

/// Metres from a cascade's middle to its sides: the last one's are `reach_m`, each finer one's a third of the next.
inline double cascade_reach(double reach_m, std::uint32_t cascade, std::uint32_t cascades) {
    return reach_m / std::pow(3.0, cascades - 1 - cascade);
}

/// How deep a map is that reaches so far, half before its middle, half behind: a low light's shadows come from afar.
inline double cascade_depth(double reach_m) { return 4 * reach_m; }

/// From metres (world axes) to u and v in [0, 1] across a cascade of this reach around `middle`, and depth in [0, 1] of
/// `depth_m`, 1 the farthest from the light.
inline glm::dmat4 cascade_matrix(const LightAxes& axes, const glm::dvec3& middle, double reach_m, double depth_m) {
    glm::dmat4 m(0);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = axes.across[i] / (2 * reach_m);
        m[i][1] = axes.along[i] / (2 * reach_m);
        m[i][2] = -axes.towards[i] / depth_m;
    }
    m[3] = {0.5 - glm::dot(middle, axes.across) / (2 * reach_m), 0.5 - glm::dot(middle, axes.along) / (2 * reach_m),
            0.5 + glm::dot(middle, axes.towards) / depth_m, 1};
    return m;
}

}  // namespace aureole::app
