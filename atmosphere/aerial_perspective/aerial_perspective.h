// Recorder of the aerial-perspective pass. What the froxels hold: aerial_perspective.glsl.
#pragma once

#include "sky_view/sky_view.h"

namespace aureole::detail {

/// What an invocation of the kernel does.
enum class FroxelWork : std::uint8_t { column, froxel };

/// Whether the froxels are the same for both blocks: they depend neither on how bright and large the suns are, nor on how the
/// picture is shown.
[[nodiscard]] bool same_froxels(const ViewBlock& a, const ViewBlock& b);

class AerialPerspectivePass {
public:
    /// `enabled` false: a texture of one black texel stands in for the froxels, and there is nothing to record but prepare().
    AerialPerspectivePass(TableViewResources& shared, const TableKernel& kernel, FroxelWork work, bool enabled);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    /// Fills the stand-in, once.
    void prepare(rhi::CommandList& commands);
    /// The froxels are lost, or their stand-in.
    void invalidate() noexcept {
        forget(table_);
        forget(stand_in_);
    }
    [[nodiscard]] bool enabled() const noexcept { return enabled_; }
    [[nodiscard]] TrackedTexture& table() noexcept { return table_; }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }

private:
    bool enabled_;
    const rhi::Shader* shader_ = nullptr;
    TrackedTexture table_;
    TrackedBuffer stand_in_;  ///< Its texel.
    rhi::Extent invocations_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

/// The tables that the composite reads of a model with sky view (null: none) and froxels.
[[nodiscard]] std::vector<LightTexture> sky_and_froxels(const TableViewResources& shared, SkyViewPass* sky_view,
                                                        AerialPerspectivePass& froxels);

}  // namespace aureole::detail
