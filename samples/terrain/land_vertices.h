// Vertices of a scene's land for programs that draw it as triangles.
#pragma once

#include "scene/scene.h"
#include "terrain/ray_caster.h"
#include "terrain/terrain.h"

namespace aureole::app {

struct LandVertex {
    glm::dvec3 point, normal;  ///< World axes; the point from the planet's centre.
    Rgb albedo;
    double open_sky;  ///< Share of the sky that the land around leaves free.
};

class LandVertices {
public:
    /// Reads the height map of a scene with terrain. Throws Error where that cannot be read.
    explicit LandVertices(const Scene& scene)
        : albedo_(scene.terrain->albedo),
          anchor_(scene.terrain->camera_east_m, scene.terrain->camera_north_m),
          field_(read_height_map(scene.terrain->height_map, scene.terrain->options), scene.terrain->vertical_exaggeration),
          caster_(field_, scene.atmosphere.planet.bottom_radius_m, anchor_) {}
    LandVertices(const LandVertices&) = delete;
    LandVertices& operator=(const LandVertices&) = delete;

    /// So far east and north of the camera's place; `spacing_m` to the next vertex.
    [[nodiscard]] LandVertex at(glm::dvec2 offset, double spacing_m) const {
        const glm::dvec2 place = anchor_ + offset;
        const double height = field_.height(place);
        const glm::dvec3 point = caster_.point_at(place, height), normal = field_.normal(place);
        return {point, caster_.to_world(point, normal), albedo_.value_or(natural_albedo(place, height, normal, spacing_m)),
                field_.open_sky(place)};
    }
    /// Height of the land below a point, and below the scene's camera, above the ground radius.
    [[nodiscard]] double ground_m(const glm::dvec3& point) const { return field_.height(caster_.place_of(point)); }
    [[nodiscard]] double ground_m() const { return field_.height(anchor_); }
    [[nodiscard]] const HeightField& field() const noexcept { return field_; }

private:
    std::optional<Rgb> albedo_;
    glm::dvec2 anchor_;
    HeightField field_;
    RayCaster caster_;
};

}  // namespace aureole::app
