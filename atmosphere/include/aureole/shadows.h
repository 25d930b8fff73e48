// Shadows in the air: the host's shadow map of one sun, sampled along the rays of the camera. Where the map is dark, the air
// scatters nothing of that sun's direct beam: shafts of light between clouds, trees and mountains.
//
//     View view(air, {.shadows = {.cascades = 2}}, ...);
//     view.set_shadow_map({.texture = map, .world_to_map = {near_cascade, far_cascade}});  // each frame that it is drawn anew
//     view.update(camera, suns);
//
// Single scattering is shadowed, and the sun's beam on the bare ground that the library draws; light that has been scattered
// more often comes from all around and is left as it is. A value out of range is Error(invalid_argument).
#pragma once

#include <aureole/rhi/types.h>

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>

namespace aureole {

/// How a View samples shadows.
struct ShadowSettings {
    static constexpr std::uint32_t max_cascades = 4;  ///< Of a host's map.

    std::uint32_t cascades = 0;    ///< In the map, in [0, 4]. 0: no shadows, no pass, the same bits as ever.
    double distance_m = 8000;      ///< Beyond it all air is lit; shadows on the bare ground reach as far as the
                                   ///< map. In [1e-3, 1e13].
    rhi::Extent size{48, 48, 32};  ///< Screen x screen x slices of the volume of losses. Each in [2, 256].
    std::uint32_t samples = 4;     ///< Of the map in each slice, in [1, 64]: what their number costs in error says shadows.md.
};

/// A shadow map: what View::set_shadow_map takes.
struct ShadowMap {
    /// Depth seen from the sun in the first channel, any format that can be sampled; the cascades side by side, equally wide,
    /// the finest first. In State::sampled or depth_read whenever a list runs into which View::record or record_composite has
    /// recorded. Null: nothing is in shadow.
    rhi::Texture texture{};
    /// From world axes (metres, as Camera::position_m) to each cascade: after division by w, u and v in [0, 1] across the
    /// cascade from the first texel of the first row, and depth as the map has it, in [0, 1]. A point outside a cascade is
    /// looked for in the next one; outside all of them it is lit. Finite numbers.
    std::array<glm::dmat4, ShadowSettings::max_cascades> world_to_map{};
    std::uint32_t sun = 0;  ///< Which of the suns given to View::update; less than ViewSettings::max_suns.
    bool reversed = false;  ///< Depth is less, rather than greater, the farther from the sun.
    double bias = 0;        ///< In depth: a point is in shadow if it lies behind the map by more. In [0, 1].
};

}  // namespace aureole
