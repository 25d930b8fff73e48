// Recorder of Psi (hillaire.glsl): rays, then their averages. All at once: there are no orders to solve one by one.
#pragma once

#include "common/pass.h"

#include <aureole/models/hillaire.h>

namespace aureole::detail {

/// 8 x 8, which each node of the table sends out (hillaire_multi_scatter_rays.comp.glsl).
inline constexpr std::uint32_t hillaire_rays_per_node = 64;

/// A column a ray, two rows a node: light scattered once, and the share of it that is scattered again.
[[nodiscard]] inline rhi::Extent hillaire_rays_extent(const models::HillaireSettings& settings) {
    return {hillaire_rays_per_node, 2 * settings.multi_scatter.width * settings.multi_scatter.height, 1};
}

class HillaireMultiScatterPass {
public:
    HillaireMultiScatterPass(AirResources& shared, TrackedTexture& transmittance, const models::HillaireSettings& settings);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    /// The table is lost, and all that it is made of.
    void invalidate() noexcept {
        forget(rays_);
        forget(table_);
    }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }

private:
    TrackedTexture rays_, table_;
    rhi::Pipeline rays_pipeline_, sum_pipeline_;
    rhi::BindingSet rays_bindings_, sum_bindings_;
};

}  // namespace aureole::detail
