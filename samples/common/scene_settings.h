// A scene's view and composite, the same in every program that shows it.
#pragma once

#include "scene/scene.h"

#include <aureole/atmosphere.h>

#include <algorithm>

namespace aureole::app {

/// The land of the scene shadows its air.
inline bool shadows_air(const Scene& scene) { return scene.terrain && scene.terrain->air_shadows_m > 0 && !scene.suns.empty(); }

/// `land`: geometry is drawn into the picture. `cascades` of the program's shadow map, where the scene's land shadows the air.
inline ViewSettings view_settings(const Scene& scene, bool land, std::uint32_t cascades = 0) {
    ViewSettings settings;
    settings.projection = scene.camera.projection;
    settings.max_suns = static_cast<std::uint32_t>(std::max<std::size_t>(scene.suns.size(), 1));
    settings.aerial_perspective = land;
    settings.aerial_perspective_distance_m = scene.aerial_perspective_distance_m;
    if (cascades > 0 && shadows_air(scene)) {
        settings.shadows.cascades = cascades;
        settings.shadows.distance_m = scene.terrain->air_shadows_m;
        settings.shadows.size = {96, 64, 42};
        settings.shadows.samples = scene.terrain->air_shadow_samples;
    }
    return settings;
}

inline CompositeSettings composite_settings(const Scene& scene, bool land) {
    CompositeSettings settings;
    settings.scene_color = settings.scene_depth = land;
    settings.sun_disk = scene.sun_disk;
    settings.sun_lobe_g = scene.sun_lobe_g;
    return settings;
}

}  // namespace aureole::app
