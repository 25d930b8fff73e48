// Recorder of the multi-scatter pass: the fixed point of multi_scatter.glsl, at once or spread over frames.
#pragma once

#include "common/pass.h"

#include <memory>

namespace aureole::detail {

/// Centre and width of the table's sun axis for a planet (AtmosphereBlock::sun_mapping, multi_scatter.glsl).
[[nodiscard]] glm::vec4 sun_mapping(const Planet& planet);

class MultiScatterPass {
public:
    /// `ratio`: order_ratio of the air. Both references outlive the pass.
    MultiScatterPass(AirResources& shared, TrackedTexture& transmittance, double ratio);

    /// Makes (or gives up) a copy of what a solution reads, for solutions that are spread over frames: each belongs to the air
    /// that it was started for, however often that changes meanwhile. May throw, and then nothing has changed.
    void keep_copy(bool wanted);
    /// The air has changed: another solution is wanted.
    void restart() noexcept { stale_ = true; }
    /// The same, for air whose order_ratio may be another one. `same_axes` false: the old table does not fit the new planet, so
    /// the solution comes at once.
    void restart(double ratio, bool same_axes) noexcept;
    /// The table is lost, and all that it is made of.
    void invalidate() noexcept;
    [[nodiscard]] bool finished() const noexcept { return !stale_ && next_ >= passes_; }
    /// Records up to `passes` passes of the fixed point for the air of `block` (0: all). A solution that has been started is
    /// finished first, for the air that it was started for. The table changes with its last pass only; true if it does.
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, int passes, PassReport& report,
                TimestampSlots timestamps, std::uint32_t index);

    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }
    /// Device memory of the copy, bytes.
    [[nodiscard]] std::uint64_t copy_bytes() const noexcept { return copy_ ? copy_->objects->texture_bytes() : 0; }

private:
    /// What a solution reads of the air.
    struct Inputs {
        rhi::Buffer block;
        rhi::Texture profiles, transmittance;
    };
    struct Bindings {
        rhi::BindingSet first_rays, next_rays[2];  // by parity of the order they read
        rhi::BindingSet first_moments;             // into the sum
        rhi::BindingSet moments[2][2];             // [last pass][parity of the order they write]
    };
    struct Copy {
        std::unique_ptr<Objects> objects;
        TrackedBuffer block;
        TrackedTexture profiles, transmittance;  // no profiles: the air has no table of them
        Bindings bindings;
    };
    /// For the newest air.
    [[nodiscard]] int passes_wanted() const noexcept;
    /// Of all airs whose tables are added up.
    [[nodiscard]] int passes_of_slowest() const noexcept;
    [[nodiscard]] Inputs live() const;
    void create();
    [[nodiscard]] Bindings bind(Objects& objects, const Inputs& inputs) const;
    void start(rhi::CommandList& commands, const AtmosphereBlock& block, bool from_copy);
    void fill_copy(rhi::CommandList& commands, const AtmosphereBlock& block);
    void record_pass(rhi::CommandList& commands, PassScope& scope);

    AirResources& shared_;
    TrackedTexture& transmittance_;
    double ratio_;             // of the newest air
    bool stale_ = true;        // no solution has been started for the newest air
    bool table_fits_ = false;  // the table can be shown until the next solution is ready
    int passes_ = 0,
        next_ = 0;  // of the solution that has been started; below 0 it waits for slower ones, to be ready with them
    float greatest_ratio_ = 0;
    TrackedTexture table_, rays_, order_[2], sum_[2];
    TrackedBuffer first_quadrature_, later_quadrature_, zenith_quadrature_;
    QuadratureBlock first_rule_, later_rule_, zenith_rule_;
    rhi::Pipeline first_rays_, next_rays_, moments_;
    Bindings live_;
    std::unique_ptr<Copy> copy_;
    const Bindings* reads_ = &live_;  // of the solution that has been started
};

}  // namespace aureole::detail
