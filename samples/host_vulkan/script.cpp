#include "host_vulkan/script.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace host_vulkan {

using namespace aureole;

std::vector<glm::dvec4> place_spheres(const app::Scene& scene, const TerrainMesh& mesh, std::uint32_t count) {
    std::vector<glm::dvec4> spheres;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double distance = 150 * std::pow(2.2, i), radius = 0.045 * distance;
        app::ScenePose pose = scene.camera.pose;
        const std::uint32_t pair = (i + 1) / 2;  // the near ones in the middle
        pose.bearing_deg += 8.0 * (i % 2 == 0 ? 1 : -1) * pair - 3;
        pose.elevation_deg = -7 + 0.5 * i;
        spheres.emplace_back(glm::dvec3(0, 0, scene.atmosphere.planet.bottom_radius_m + mesh.camera_altitude_m) +
                                 distance * app::direction_of(pose),
                             radius);
    }
    return spheres;
}

Script::Script(const app::Scene& scene, const Options& options, double altitude_m, double exposure)
    : scene_(scene), options_(options), altitude_m_(altitude_m), suns_(app::suns_of(scene)) {
    for (Sun& sun : suns_) sun.irradiance *= exposure;
}

void Script::turn(const Window::Turn& turn) {
    scene_.camera.pose.bearing_deg += turn.right_deg;
    scene_.camera.pose.elevation_deg = std::clamp(scene_.camera.pose.elevation_deg + turn.up_deg, -89.0, 89.0);
}

double Script::sway(std::uint32_t frame) const {
    if (options_.frames < 2 || frame + 1 == options_.frames) return 0;  // the last one is the scene's own, to the last bit
    return options_.sway_deg * std::sin(2 * std::numbers::pi * frame / (options_.frames - 1));
}

const std::vector<Sun>& Script::suns(std::uint32_t frame) {
    for (std::size_t i = 0; i < suns_.size(); ++i) {
        app::ScenePose pose = scene_.suns[i].pose;
        pose.elevation_deg = std::clamp(pose.elevation_deg + 0.2 * sway(frame), -90.0, 90.0);
        suns_[i].direction = app::direction_of(pose);
    }
    return suns_;
}

Camera Script::camera(std::uint32_t frame, VkExtent2D size) {
    const double bearing_deg = scene_.camera.pose.bearing_deg;
    scene_.camera.pose.bearing_deg += sway(frame);
    const Camera made = app::camera_of(scene_, altitude_m_, size.width, size.height);
    scene_.camera.pose.bearing_deg = bearing_deg;
    return made;
}

VkExtent2D Script::size(std::uint32_t frame) const {
    if (options_.resize_every == 0 || frame + 1 == options_.frames) return options_.size;
    constexpr double shares[][2] = {{1, 1}, {0.75, 0.9}, {0.5, 1.1}};
    const auto& share = shares[frame / options_.resize_every % 3];
    const auto scaled = [](std::uint32_t side, double by) { return std::max(static_cast<std::uint32_t>(side * by), 16U); };
    return {scaled(options_.size.width, share[0]), scaled(options_.size.height, share[1])};
}

}  // namespace host_vulkan
