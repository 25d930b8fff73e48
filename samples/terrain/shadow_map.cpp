#include "terrain/shadow_map.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace aureole::app {

TerrainShadows cast_shadows(const RayCaster& caster, const glm::dvec3& middle, const glm::dvec3& towards_light,
                            double reach_m) {
    constexpr std::uint32_t n = TerrainShadows::side, width = n * TerrainShadows::cascades;
    // The plane from which rays start is as far in front of the middle as the map is wide: a low light's shadows come from
    // afar.
    const double range = 4 * reach_m;
    const glm::dvec3 helper = std::abs(towards_light.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(helper, towards_light)), along = glm::cross(towards_light, across);

    TerrainShadows shadows;
    shadows.depth.assign(std::size_t{width} * n, 1.0F);
    for (std::uint32_t c = 0; c < TerrainShadows::cascades; ++c) {
        const double reach = reach_m / std::pow(3.0, TerrainShadows::cascades - 1 - c);
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::uint32_t>(0, n), [&](const auto& rows) {
            for (std::uint32_t y = rows.begin(); y < rows.end(); ++y)
                for (std::uint32_t x = 0; x < n; ++x) {
                    const double u = (x + 0.5) / n * 2 - 1, v = (y + 0.5) / n * 2 - 1;
                    const glm::dvec3 start = middle + reach * (u * across + v * along) + range / 2 * towards_light;
                    if (const auto hit = caster.cast(start, -towards_light, 0, range))
                        shadows.depth[std::size_t{y} * width + c * n + x] = static_cast<float>(hit->distance_m / range);
                }
        });
        glm::dmat4 m(0);
        for (int i = 0; i < 3; ++i) {
            m[i][0] = across[i] / (2 * reach);
            m[i][1] = along[i] / (2 * reach);
            m[i][2] = -towards_light[i] / range;
        }
        m[3] = {0.5 - glm::dot(middle, across) / (2 * reach), 0.5 - glm::dot(middle, along) / (2 * reach),
                0.5 + glm::dot(middle, towards_light) / range, 1};
        shadows.world_to_map.push_back(m);
    }
    return shadows;
}

}  // namespace aureole::app
