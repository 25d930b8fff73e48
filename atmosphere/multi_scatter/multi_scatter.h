// Recorder of the multi-scatter pass: the fixed point of multi_scatter.glsl, at once or spread over frames.
#pragma once

#include "common/pass.h"

namespace aureole::detail {

/// Centre and width of the table's sun axis for a planet (AtmosphereBlock::sun_mapping, multi_scatter.glsl).
[[nodiscard]] glm::vec4 sun_mapping(const Planet& planet, Sampling sampling);

class MultiScatterPass {
public:
    /// `ratio`: order_ratio of the air.
    MultiScatterPass(AirResources& shared, TrackedTexture& transmittance, double ratio);

    /// Starts anew: the air has changed.
    void restart() noexcept { next_ = 0; }
    /// The same, for air whose order_ratio may be another one.
    void restart(double ratio) noexcept;
    [[nodiscard]] bool finished() const noexcept { return next_ >= passes_; }
    /// Records up to `passes` passes of the fixed point (0: all that remain). The table changes with the last one only.
    void record(rhi::CommandList& commands, int passes, PassReport& report, TimestampSlots timestamps, std::uint32_t index);

    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }

private:
    void create_gauss(AirResources& shared, TrackedTexture& transmittance);
    void create_published(AirResources& shared, TrackedTexture& transmittance);
    void record_gauss(rhi::CommandList& commands, PassScope& scope);
    void record_published(rhi::CommandList& commands, PassScope& scope);

    bool published_;
    int orders_, passes_, next_ = 0;
    float greatest_ratio_;
    TrackedTexture table_, rays_, order_[2], sum_[2];
    TrackedBuffer ray_quadrature_, zenith_quadrature_;
    QuadratureBlock ray_rule_, zenith_rule_;
    rhi::Pipeline first_rays_, next_rays_, moments_;
    rhi::BindingSet first_rays_bindings_, next_rays_bindings_[2];  // by parity of the order they read
    rhi::BindingSet moments_bindings_[2][2];                       // [last pass][parity of the order they write]
    rhi::BindingSet first_moments_bindings_[2];                    // [last pass]
};

}  // namespace aureole::detail
