// Recorder of the sky-view pass. What the table holds: sky_view.glsl.
#pragma once

#include "models/model.h"

namespace aureole::detail {

/// The tables that the passes of a view read.
struct TableViewResources : ViewResources {
    TrackedTexture& transmittance;
    TrackedTexture& multi_scatter;
    std::uint32_t layers_per_sun = 1;                   ///< In the sky-view table and in the froxels.
    std::vector<rhi::Specialization> specialization{};  ///< Of the model's tables, beyond ViewResources::specialize.
    /// Specialization of the kernels that fill the tables.
    [[nodiscard]] Specialize specialize_tables() const;
};

/// Layers a sun has in tables that keep sharp phase functions apart: 1, and 1 for each of those.
[[nodiscard]] std::uint32_t layers_with_sharp_phases(const AirStructure& air);

/// Everything that a sky-view table depends on: rotating the camera does not change it.
struct SkyViewKey {
    glm::vec4 camera, space, exposure;
    glm::vec2 suns[max_suns];  ///< Cosine and sine of the zenith angle.
    [[nodiscard]] static SkyViewKey of(const ViewBlock& block);
    [[nodiscard]] bool operator==(const SkyViewKey&) const noexcept = default;
};

class SkyViewPass {
public:
    SkyViewPass(TableViewResources& shared, const TableKernel& kernel);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    /// The table is lost, and all that it is made of.
    void invalidate() noexcept {
        forget(table_);
        forget(quadrature_);
    }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }

private:
    const rhi::Shader* shader_;
    TrackedTexture table_;
    rhi::Extent invocations_;
    QuadratureBlock rule_;
    TrackedBuffer quadrature_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

}  // namespace aureole::detail
