// Texels of the multi-scatter pass's textures, for who makes them, checks a device for them, or foretells their cost.
#pragma once

#include "multi_scatter/moments.h"

#include <aureole/quality.h>

namespace aureole::detail {

/// Rays that each texel of the settings' extent sends out.
[[nodiscard]] inline std::uint32_t multi_scatter_directions(const QualitySettings& quality) {
    return static_cast<std::uint32_t>(2 * quality.multi_scatter_zenith * quality.multi_scatter_azimuth);
}

/// One layer of altitude rows a moment, and a row for the ground.
[[nodiscard]] inline rhi::Extent multi_scatter_table_extent(const QualitySettings& quality) {
    return {quality.multi_scatter.width, quality.multi_scatter.height * moment_count(quality.angular_order) + 1, 1};
}

/// One layer of altitude rows a direction.
[[nodiscard]] inline rhi::Extent multi_scatter_rays_extent(const QualitySettings& quality) {
    return {quality.multi_scatter.width, quality.multi_scatter.height * multi_scatter_directions(quality), 1};
}

}  // namespace aureole::detail
