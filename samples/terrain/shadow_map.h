// A shadow map of the land, ray-cast on the CPU: what a game's renderer would draw.
#pragma once

#include "terrain/ray_caster.h"

#include <glm/mat4x4.hpp>
#include <vector>

namespace aureole::app {

/// Cascades side by side, the finest first, around a point; as aureole::ShadowMap takes them (shadows.h).
struct TerrainShadows {
    static constexpr std::uint32_t cascades = 3, side = 512;  ///< Texels of each cascade.
    std::vector<float> depth;                                 ///< cascades * side by side; 1 where the light meets no land.
    std::vector<glm::dmat4> world_to_map;
};

/// `towards_light`: unit vector, world axes. The last cascade reaches `reach_m` to all sides of `middle`, each finer one a
/// third as far.
[[nodiscard]] TerrainShadows cast_shadows(const RayCaster& caster, const glm::dvec3& middle, const glm::dvec3& towards_light,
                                          double reach_m);

}  // namespace aureole::app
