// Recorder of the light pass: sky harmonics and sun colour for the host's own lights. What the table holds: light.comp.glsl.
#pragma once

#include "models/model.h"

namespace aureole::detail {

/// Of the light's integral: light/directions.glsl.
constexpr int light_zeniths = 8;
constexpr std::uint32_t light_directions = 192;
/// Specialization of every kernel that evaluates the sky for it.
[[nodiscard]] Specialize light_specialization(const ViewResources& shared);

class LightPass {
public:
    /// `enabled` false: nothing is made or recorded.
    LightPass(ViewResources& shared, const ModelKernels& kernels, bool enabled);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    /// The table is lost, and all that it is made of.
    void invalidate() noexcept {
        forget(table_);
        forget(quadrature_);
        for (TrackedTexture& sum : sums_) forget(sum);
    }
    [[nodiscard]] bool enabled() const noexcept { return enabled_; }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }

private:
    /// In RGB, or of three of N wavelengths.
    struct Run {
        const rhi::Shader* shader;
        rhi::Pipeline pipeline;
        rhi::BindingSet bindings;
    };
    [[nodiscard]] TrackedTexture& written_by(std::size_t run) noexcept {
        return run + 1 < runs_.size() ? sums_[run % sums_.size()] : table_;
    }

    bool enabled_;
    TrackedTexture table_;
    TrackedBuffer quadrature_;
    QuadratureBlock rule_;
    std::vector<Run> runs_;
    std::vector<TrackedTexture> sums_;  ///< What one run leaves to the next.
};

}  // namespace aureole::detail
