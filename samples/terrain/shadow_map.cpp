#include "terrain/shadow_map.h"

#include "common/cascades.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

namespace aureole::app {

TerrainShadows cast_shadows(const RayCaster& caster, const glm::dvec3& middle, const glm::dvec3& towards_light,
                            double reach_m) {
    constexpr std::uint32_t n = TerrainShadows::side, width = n * TerrainShadows::cascades;
    const double range = cascade_depth(reach_m);
    const LightAxes axes(towards_light);

    TerrainShadows shadows;
    shadows.depth.assign(std::size_t{width} * n, 1.0F);
    for (std::uint32_t c = 0; c < TerrainShadows::cascades; ++c) {
        const double reach = cascade_reach(reach_m, c, TerrainShadows::cascades);
        oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::uint32_t>(0, n), [&](const auto& rows) {
            for (std::uint32_t y = rows.begin(); y < rows.end(); ++y)
                for (std::uint32_t x = 0; x < n; ++x) {
                    const double u = (x + 0.5) / n * 2 - 1, v = (y + 0.5) / n * 2 - 1;
                    const glm::dvec3 start = middle + reach * (u * axes.across + v * axes.along) + range / 2 * towards_light;
                    if (const auto hit = caster.cast(start, -towards_light, 0, range))
                        shadows.depth[std::size_t{y} * width + c * n + x] = static_cast<float>(hit->distance_m / range);
                }
        });
        shadows.world_to_map.push_back(cascade_matrix(axes, middle, reach, range));
    }
    return shadows;
}

}  // namespace aureole::app
