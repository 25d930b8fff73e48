// Texels of the solution's textures, for who makes them, checks a device for them, or lists them.
#pragma once

#include <aureole/models/bruneton.h>

namespace aureole::detail {

/// Zenith nodes of half the sphere, and azimuth nodes of half a turn, in which light arrives at a point.
struct BrunetonDirections {
    int zenith_nodes, azimuth_nodes;
    /// Of the sphere, less what is alike left and right of the sun.
    [[nodiscard]] int count() const { return 2 * zenith_nodes * azimuth_nodes; }
};
[[nodiscard]] inline BrunetonDirections bruneton_directions(const models::BrunetonSettings& settings) {
    if (settings.sampling == models::BrunetonSampling::published) return {8, 16};  // 16 x 32 over the sphere
    return {settings.zenith_nodes, settings.azimuth_nodes};
}

/// Of one layer of altitudes of the scattering table, and of the source that it is integrated from.
[[nodiscard]] inline rhi::Extent bruneton_scattering_extent(const models::BrunetonSettings& settings) {
    return {static_cast<std::uint32_t>(settings.nu_nodes * settings.sun_nodes), static_cast<std::uint32_t>(settings.view_nodes),
            static_cast<std::uint32_t>(settings.altitude_nodes)};
}

/// Of the field of light that arrives at each point.
[[nodiscard]] inline rhi::Extent bruneton_field_extent(const models::BrunetonSettings& settings) {
    return {static_cast<std::uint32_t>(settings.sun_nodes), static_cast<std::uint32_t>(bruneton_directions(settings).count()),
            static_cast<std::uint32_t>(settings.altitude_nodes)};
}

}  // namespace aureole::detail
