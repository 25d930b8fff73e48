// Recorder of the sky-view pass. What the table holds: sky_view.glsl.
#pragma once

#include "common/pass.h"

namespace aureole::detail {

/// The tables and blocks that the passes of a view read.
struct ViewResources {
    Objects& objects;
    AirResources& air;
    TrackedTexture& transmittance;
    TrackedTexture& multi_scatter;
    TrackedBuffer& block;  ///< ViewBlock
    std::uint32_t suns;    ///< Rows of suns in every table of the view.
    Projection projection;
    /// Specialization of every kernel that reads or writes a view's tables.
    [[nodiscard]] Specialize specialize() const;
    /// Layers a sun has in the view's tables: 1, and 1 for each sharp phase function.
    [[nodiscard]] std::uint32_t layers_per_sun() const;
};

/// Everything that a sky-view table depends on: rotating the camera does not change it.
struct SkyViewKey {
    glm::vec4 camera, space, exposure;
    glm::vec2 suns[max_suns];  ///< Cosine and sine of the zenith angle.
    [[nodiscard]] static SkyViewKey of(const ViewBlock& block);
    [[nodiscard]] bool operator==(const SkyViewKey&) const noexcept = default;
};

class SkyViewPass {
public:
    explicit SkyViewPass(ViewResources& shared);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    /// The table is lost, and all that it is made of.
    void invalidate() noexcept {
        forget(table_);
        forget(quadrature_);
    }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }

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
