// Recorder of the transmittance pass. What the table holds: transmittance.glsl.
#pragma once

#include "common/pass.h"

namespace aureole::detail {

/// The kernel that integrates with nodes, at a table's size and format.
[[nodiscard]] TableKernel transmittance_kernel(const QualitySettings& quality);

class TransmittancePass {
public:
    /// `copies`: what else the table is used for.
    TransmittancePass(AirResources& shared, const TableKernel& kernel, rhi::Usage copies = rhi::Usage::copy_source);

    /// The first recording also fills the quadrature block.
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
    TrackedBuffer quadrature_;  ///< Null: the kernel has none.
    QuadratureBlock rule_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

}  // namespace aureole::detail
