// Flying: the camera of a scene moved by keys and mouse, at a speed that fits the altitude.
//
// A scene's camera stands on the planet's +z axis and everything has its bearing there. So to fly along is to turn the planet
// below the camera: the land's place changes by the way over the ground, and the suns, which stay where they are in space, get
// other bearings and elevations.
#pragma once

#include "scene/scene.h"

#include <glm/vec2.hpp>

namespace aureole::viewer {

/// Of one moment, each in [-1, 1].
struct Stick {
    double forward = 0, right = 0, up = 0;
    bool fast = false;  ///< Five times as fast.
    [[nodiscard]] bool moves() const { return forward != 0 || right != 0 || up != 0; }
};

/// Metres a second at this height above the ground: its own height in 1.25 s, but at least 5 m/s.
[[nodiscard]] double flight_speed(double height_m);

/// Flies for `seconds`. `ground_m`: of the land below the camera, above the ground radius; the camera stays 2 m above it, and
/// within 40 of the planet's radii. A camera with a clearance gets an altitude. Forward is where the camera looks, level; up is
/// up. Beyond perspective pictures `right` and `forward` do the same.
void fly(app::Scene& scene, double ground_m, const Stick& stick, double seconds);

/// Moves the camera over the ground by (east, north) metres, and the suns with it.
void move_over_ground(app::Scene& scene, glm::dvec2 metres);

/// Turns the camera, degrees. Bearings stay in [-180, 180], elevations in [-90, 90].
void turn(app::ScenePose& pose, double bearing_deg, double elevation_deg);

/// Pose of a direction in world axes, of any length above 0.
[[nodiscard]] app::ScenePose pose_of(const glm::dvec3& direction);

/// Where a point of the picture looks, x and y in [0, 1] from its upper left corner; perspective cameras alone.
[[nodiscard]] app::ScenePose pose_at(const app::Scene& scene, double x, double y, double aspect);

/// The first sun by a drag of the mouse to this point: under it in a perspective picture, which shows (aspect) width to height;
/// in others by as many degrees as `moved` (a share of the picture's height) is of the sky.
void drag_sun(app::Scene& scene, double x, double y, double aspect, glm::dvec2 moved);

}  // namespace aureole::viewer
