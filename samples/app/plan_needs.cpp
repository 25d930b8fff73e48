#include "app/plan_needs.h"

#include <algorithm>

namespace aureole::app {

PlanRequirements plan_needs(const Scene& scene) {
    PlanRequirements needs;
    needs.air = scene.atmosphere;
    needs.altitude_m = {scene.camera.altitude_m, scene.camera.altitude_m};
    if (!scene.suns.empty()) {
        const auto elevation = [](const SceneSun& sun) { return sun.pose.elevation_deg; };
        const auto [least, most] = std::ranges::minmax(scene.suns, {}, elevation);
        needs.sun_elevation_deg = {elevation(least), elevation(most)};
        needs.suns = static_cast<std::uint32_t>(scene.suns.size());
    }
    needs.projection = scene.camera.projection;
    needs.geometry = scene.terrain.has_value();
    needs.geometry_range_m = scene.aerial_perspective_distance_m;
    needs.shadows = scene.terrain && scene.terrain->air_shadows_m > 0;
    needs.wavelengths = !scene.model.in_rgb();
    needs.width = scene.width;
    needs.height = scene.height;
    return needs;
}

}  // namespace aureole::app
