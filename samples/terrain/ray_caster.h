// Where a ray meets a height field that lies on a planet.
#pragma once

#include "terrain/height_field.h"

#include <optional>

namespace aureole::app {

/// World axes as in scene.h: origin at the planet's centre, +z through `anchor`, +x north, +y west. The map is laid on the
/// sphere so that distances and bearings from the anchor are kept (azimuthal equidistant).
class RayCaster {
public:
    /// `anchor`: the place (east, north) of the field that stands on the +z axis. The field must outlive the caster.
    RayCaster(const HeightField& field, double planet_radius_m, glm::dvec2 anchor);

    struct Hit {
        double distance_m;
        glm::dvec2 place;
    };
    /// First meeting at a distance in [from, to]; `direction` is a unit vector. A ray that starts inside the land meets
    /// it at once; one that only grazes the land inside one grid cell may miss it.
    [[nodiscard]] std::optional<Hit> cast(const glm::dvec3& origin, const glm::dvec3& direction, double from_m,
                                          double to_m) const;

    /// Place below (or above) a point, and back to a point at a height above the planet's ground radius.
    [[nodiscard]] glm::dvec2 place_of(const glm::dvec3& point) const;
    [[nodiscard]] glm::dvec3 point_at(glm::dvec2 place, double height_m) const;
    /// Turns (east, north, up) at a point into world axes.
    [[nodiscard]] glm::dvec3 to_world(const glm::dvec3& point, const glm::dvec3& local) const;
    [[nodiscard]] double altitude_of(const glm::dvec3& point) const;

private:
    struct Line;
    [[nodiscard]] std::optional<Hit> refine(const Line& line, double above_m, double below_m) const;

    const HeightField& field_;
    double radius_;
    glm::dvec2 anchor_;
};

}  // namespace aureole::app
