// The terrain of a scene on its way from the height map to the composite.
#pragma once

#include "app/backend.h"
#include "scene/scene.h"
#include "terrain/shadow_map.h"
#include "terrain/terrain.h"

#include <aureole/atmosphere.h>

#include <memory>

namespace aureole::app {

/// The loaded terrain of a scene.
class Land {
public:
    /// Reads the height map. Throws Error: io, invalid_argument (also if the camera stands inside the land).
    Land(const Scene& scene, const std::filesystem::path& height_map);

    /// Where this scene has its camera, its planet and how the land looks, on the height map as it was read. Throws
    /// Error(invalid_argument) if the camera stands inside the land, and changes nothing then.
    void follow(const Scene& scene);

    [[nodiscard]] double camera_altitude_m() const noexcept { return camera_altitude_m_; }
    /// Of the land below the camera, above the planet's ground radius.
    [[nodiscard]] double ground_m() const noexcept { return ground_m_; }

    /// Light of the suns at the lowest and the highest point, from the tables of `air` (left recorded).
    [[nodiscard]] TerrainLight measure_light(Backend& backend, Atmosphere& air, const std::vector<Sun>& suns) const;
    [[nodiscard]] TerrainPicture cast(const Camera& camera, const TerrainLight& light, std::uint32_t width,
                                      std::uint32_t height) const;

    /// Shadow map around the camera for a light in this direction (unit, world axes).
    [[nodiscard]] TerrainShadows cast_shadows(const Camera& camera, const glm::dvec3& towards_light, double reach_m) const {
        return app::cast_shadows(*caster_, camera.position_m, towards_light, reach_m);
    }

private:
    double bottom_radius_m_ = 0;
    TerrainLook look_;
    std::unique_ptr<HeightField> field_;
    std::unique_ptr<RayCaster> caster_;
    double camera_altitude_m_ = 0, ground_m_ = 0;
};

}  // namespace aureole::app
