// A point is in the map's shadow where a ray from it towards the light meets land, and only there.
#include "terrain/shadow_map.h"

#include <doctest/doctest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace aureole::app;

TEST_CASE("shadow map: it says what a ray to the light says, in every cascade") {
    constexpr std::uint32_t side = 81;
    HeightMap map{side, side, {}, 100, 100};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            map.meters.push_back(static_cast<float>(300 + 250 * std::sin(0.31 * x) * std::cos(0.23 * y)));
    const HeightField field(map, 1);
    const RayCaster caster(field, 6.36e6, {0, 0});
    const glm::dvec3 middle(0, 0, 6.36e6 + 700);
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.8, 0.4, 0.3));
    const TerrainShadows shadows = cast_shadows(caster, middle, light, 3000);
    REQUIRE(shadows.world_to_map.size() == TerrainShadows::cascades);

    std::minstd_rand random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (std::uint32_t c = 0; c < TerrainShadows::cascades; ++c) {
        CAPTURE(c);
        const double reach = 3000 / std::pow(3.0, TerrainShadows::cascades - 1 - c);
        int asked = 0, agreed = 0, dark = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 point =
                middle + 0.5 * reach * glm::dvec3(unit(random), unit(random), 0) - glm::dvec3(0, 0, 300 * (1 + unit(random)));
            const glm::dvec4 at = shadows.world_to_map[c] * glm::dvec4(point, 1);
            if (at.x < 0 || at.x >= 1 || at.y < 0 || at.y >= 1) continue;
            const auto x = static_cast<std::size_t>(at.x * TerrainShadows::side),
                       y = static_cast<std::size_t>(at.y * TerrainShadows::side);
            const float stored =
                shadows.depth[y * TerrainShadows::side * TerrainShadows::cascades + c * TerrainShadows::side + x];
            const bool hidden = caster.cast(point, light, 0, 5e3).has_value();
            ++asked;
            agreed += (at.z > stored) == hidden ? 1 : 0;
            dark += hidden ? 1 : 0;
        }
        CHECK(asked > 1000);
        CHECK(dark > asked / 20);
        CHECK(dark < asked - asked / 20);
        CHECK(agreed > asked - asked / 50);  // the rest lies at an edge, within a texel
    }
}
