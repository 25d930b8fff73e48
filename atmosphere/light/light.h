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
    }
    [[nodiscard]] bool enabled() const noexcept { return enabled_; }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }

private:
    bool enabled_;
    const rhi::Shader* shader_;
    TrackedTexture table_;
    TrackedBuffer quadrature_;
    QuadratureBlock rule_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

}  // namespace aureole::detail
