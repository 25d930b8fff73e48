#include "host_vulkan/cascades.h"

#include "common/cascades.h"

#include <cmath>

namespace host_vulkan {

using namespace aureole::app;

Cascades cascades_around(const glm::dvec3& camera_m, const glm::dvec3& towards_sun, double reach_m) {
    const LightAxes axes(towards_sun);
    Cascades cascades;
    cascades.depth_m = cascade_depth(reach_m);
    for (std::uint32_t c = 0; c < Cascades::count; ++c) {
        const double reach = cascade_reach(reach_m, c, Cascades::count);
        const double texel = cascades.texel_m[c] = 2 * reach / Cascades::side;
        // Whole texels of the world, so that edges do not crawl when the camera moves.
        const auto beyond = [&](const glm::dvec3& axis) {
            const double place = glm::dot(camera_m, axis);
            return (place - std::floor(place / texel) * texel) * axis;
        };
        cascades.camera_to_map[c] = cascade_matrix(axes, -beyond(axes.across) - beyond(axes.along), reach, cascades.depth_m);
    }
    return cascades;
}

}  // namespace host_vulkan
