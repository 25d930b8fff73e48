// Recorder of the dome: single scattering at the vertices of a sky around the camera. What the table holds: dome.glsl.
#pragma once

#include "models/model.h"

#include <aureole/models/single.h>

#include <string>

namespace aureole::detail {

/// As Model::tables_for has it.
[[nodiscard]] inline ModelTable dome_table(const models::Dome& dome, int view_steps) {
    return {"dome", dome.size, dome.format, std::to_string(view_steps) + " steps a ray"};
}

class DomePass {
public:
    /// `field`: the dome's name in errors. `kernel` takes those of `bindings` that it has slots for.
    DomePass(ViewResources& shared, const std::string& field, const models::Dome& dome, const rhi::Shader& kernel,
             std::span<const rhi::Binding> bindings, std::span<const rhi::Specialization> specialization);

    void record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);
    void invalidate() noexcept { forget(table_); }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }

private:
    const rhi::Shader* shader_;
    rhi::Extent invocations_;
    TrackedTexture table_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

}  // namespace aureole::detail
