#include "viewer/core/flight.h"

#include "terrain/pixel_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace aureole::viewer {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_clearance_m = 2;
constexpr double most_radii = 40;

double wrapped(double bearing_deg) {
    const double turns = std::remainder(bearing_deg, 360.0);
    return turns == 0 ? 0 : turns;  // no negative zero
}

}  // namespace

double flight_speed(double height_m) { return std::max(5.0, 0.8 * height_m); }

app::ScenePose pose_of(const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(direction);
    app::ScenePose pose;
    pose.elevation_deg = std::asin(std::clamp(d.z, -1.0, 1.0)) / degree;
    pose.bearing_deg = d.x == 0 && d.y == 0 ? 0 : std::atan2(-d.y, d.x) / degree;  // +x north, +y west
    return pose;
}

void turn(app::ScenePose& pose, double bearing_deg, double elevation_deg) {
    pose.bearing_deg = wrapped(pose.bearing_deg + bearing_deg);
    pose.elevation_deg = std::clamp(pose.elevation_deg + elevation_deg, -90.0, 90.0);
}

void move_over_ground(app::Scene& scene, glm::dvec2 metres) {
    const double way = std::hypot(metres.x, metres.y);
    if (way == 0) return;
    if (scene.terrain) {
        scene.terrain->camera_east_m += metres.x;
        scene.terrain->camera_north_m += metres.y;
    }
    // Zenith goes towards `ahead` by the angle; seen from the camera all else goes the other way.
    const glm::dvec3 ahead = glm::dvec3(metres.y, -metres.x, 0.0) / way, up(0, 0, 1);
    const double angle = way / scene.atmosphere.planet.bottom_radius_m;
    const auto carried = [&](const glm::dvec3& d) {
        const double along = glm::dot(d, ahead), above = glm::dot(d, up);
        const glm::dvec3 aside = d - along * ahead - above * up;
        return aside + (along * std::cos(angle) - above * std::sin(angle)) * ahead +
               (above * std::cos(angle) + along * std::sin(angle)) * up;
    };
    for (app::SceneSun& sun : scene.suns) sun.pose = pose_of(carried(app::direction_of(sun.pose)));
}

void fly(app::Scene& scene, double ground_m, const Stick& stick, double seconds) {
    if (!stick.moves()) return;
    app::SceneCamera& camera = scene.camera;
    if (camera.clearance_m) {
        camera.altitude_m = ground_m + *camera.clearance_m;
        camera.clearance_m.reset();
    }
    const double step = flight_speed(camera.altitude_m - ground_m) * seconds * (stick.fast ? 5 : 1);
    const double radius = scene.atmosphere.planet.bottom_radius_m;
    camera.altitude_m = std::clamp(camera.altitude_m + stick.up * step, ground_m + least_clearance_m, most_radii * radius);
    // The way over the ground is shorter than that of a camera high above it.
    const double over_ground = step * radius / (radius + std::max(camera.altitude_m, 0.0));
    const double b = camera.pose.bearing_deg * degree;
    const glm::dvec2 forward(std::sin(b), std::cos(b)), right(std::cos(b), -std::sin(b));  // (east, north)
    move_over_ground(scene, (stick.forward * forward + stick.right * right) * over_ground);
}

app::ScenePose pose_at(const app::Scene& scene, double x, double y, double aspect) {
    constexpr std::uint32_t side = 1000;  // PixelRays counts pixels: half a pixel is no matter
    app::Scene level = scene;
    level.camera.projection = Projection::matrix;
    const auto width = static_cast<std::uint32_t>(std::lround(side * aspect));
    const Camera camera = app::camera_of(level, std::max(scene.camera.altitude_m, 0.0), width, side);
    const app::PixelRays rays(camera, width, side);
    const auto pixel = [](double share, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(share * count, 0.0, count - 1.0));
    };
    return pose_of(rays.to_world * rays.in_view(pixel(x, width), pixel(y, side)));
}

void drag_sun(app::Scene& scene, double x, double y, double aspect, glm::dvec2 moved) {
    if (scene.suns.empty()) return;
    app::ScenePose& sun = scene.suns.front().pose;
    if (scene.camera.projection == Projection::matrix)
        sun = pose_at(scene, x, y, aspect);
    else
        turn(sun, moved.x * 180, -moved.y * 180);
}

}  // namespace aureole::viewer
