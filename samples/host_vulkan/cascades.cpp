#include "host_vulkan/cascades.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace host_vulkan {

Cascades cascades_around(const glm::dvec3& camera_m, const glm::dvec3& towards_sun, double reach_m) {
    const glm::dvec3 helper = std::abs(towards_sun.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(helper, towards_sun)), along = glm::cross(towards_sun, across);
    Cascades cascades;
    cascades.depth_m = 4 * reach_m;  // a low sun's shadows come from afar
    for (std::uint32_t c = 0; c < Cascades::count; ++c) {
        const double width = 2 * reach_m / std::pow(3.0, Cascades::count - 1 - c);
        const double texel = cascades.texel_m[c] = width / Cascades::side;
        // Whole texels of the world, so that edges do not crawl when the camera moves.
        const auto snapped = [&](const glm::dvec3& axis) {
            const double place = glm::dot(camera_m, axis);
            return place - std::floor(place / texel) * texel;
        };
        glm::dmat4& m = cascades.camera_to_map[c] = glm::dmat4(0);
        for (int i = 0; i < 3; ++i) {
            m[i][0] = across[i] / width;
            m[i][1] = along[i] / width;
            m[i][2] = -towards_sun[i] / cascades.depth_m;
        }
        m[3] = {0.5 + snapped(across) / width, 0.5 + snapped(along) / width, 0.5, 1};
    }
    return cascades;
}

}  // namespace host_vulkan
