// Recorder of the pass that shows two composites over each other.
#pragma once

#include "common/pass.h"

#include <memory>
#include <vector>

namespace aureole::detail {

class CrossfadePass {
public:
    /// `frame` outlives this object: objects given up die in that frame.
    CrossfadePass(rhi::Device& device, const std::uint64_t& frame, rhi::Format target_format, bool raster);

    /// Two pictures of the target's size to composite into, in place of the target.
    struct Pictures {
        TrackedTexture before, after;
    };
    /// Makes what a fade into this target needs, unless that is there; true if it was not. Throws and changes nothing if the
    /// device refuses.
    bool prepare(rhi::Texture target, rhi::Extent extent);
    void release(rhi::Texture target) noexcept;
    /// Null of a target that is not prepared.
    [[nodiscard]] Pictures* pictures(rhi::Texture target) noexcept;
    /// The state in which a composite wants its target.
    [[nodiscard]] rhi::State written() const noexcept;
    /// Both pictures have been written; into the texture, a target which is prepared, in written(), and stays there. `share`:
    /// of the second.
    void record(rhi::CommandList& commands, rhi::Texture texture, double share);
    /// What the pictures hold is lost.
    void invalidate() noexcept;

private:
    struct Target {
        rhi::Texture texture;
        std::unique_ptr<Objects> objects;
        Pictures pictures;
        rhi::BindingSet bindings;
    };
    [[nodiscard]] Target* find(rhi::Texture target) noexcept;

    Objects objects_;
    rhi::Format format_;
    bool raster_;
    rhi::Sampler nearest_;
    rhi::Pipeline pipeline_;
    std::vector<Target> targets_;
};

}  // namespace aureole::detail
