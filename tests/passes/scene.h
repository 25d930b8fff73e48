// What a host brings to the composite: colour and depth of a made-up landscape, in every convention of depth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "passes/rig.h"

namespace aureole::passes {

/// Distance of a pixel's geometry along the view axis, metres; infinity where there is none.
using Landscape = std::function<double(std::uint32_t x, std::uint32_t y)>;
/// Patches from 20 m to 80 km, and holes.
[[nodiscard]] double patches(std::uint32_t x, std::uint32_t y);

/// One way to write depth into a buffer.
struct DepthConvention {
    std::string name;
    glm::dmat4 projection;
    DepthRange range = DepthRange::zero_to_one;

    /// What the depth buffer holds there.
    [[nodiscard]] double stored(double distance_m) const;
};
/// Perspective: forward, reversed, infinite, in either depth range.
[[nodiscard]] std::vector<DepthConvention> perspective_conventions(double aspect);
/// Orthographic: forward, reversed, in either depth range.
[[nodiscard]] std::vector<DepthConvention> orthographic_conventions(double aspect);

struct SceneTextures {
    rhi::Texture color, depth;
};
/// Uploads the landscape. Rows are in the order of `order`.
[[nodiscard]] SceneTextures upload(Backend& backend, rhi::Extent extent, const Landscape& landscape,
                                   const DepthConvention& convention, RowOrder order = RowOrder::top_first,
                                   rhi::Format depth_format = rhi::Format::r32_float);

}  // namespace aureole::passes
