// Recorder of the composite pass: composite.glsl as compute or as a full-screen draw into the host's target.
#pragma once

#include "models/model.h"
#include "shadows/shadows.h"

#include <memory>
#include <vector>

namespace aureole::detail {

void validate(const CompositeSettings& settings);
/// Throws Error(invalid_argument) naming what is missing, given twice, or of another format or size; (unsupported) for
/// directions with `shadows`.
void check_targets(const rhi::Device& device, const CompositeSettings& settings, bool shadows, const CompositeTargets& targets);

class CompositePass {
public:
    CompositePass(ViewResources& shared, const ModelKernels& kernels, const ShadowPass& shadows,
                  const CompositeSettings& settings);

    /// Makes bindings for these textures, and forgets the longest unused ones beyond `max_prepared`.
    void prepare(const CompositeTargets& targets);
    /// Makes bindings for all textures that the other pass is prepared for, longest unused first.
    void prepare_as(const CompositePass& other);

    /// What was left between runs is lost.
    void invalidate() noexcept;

    struct Prepared {
        CompositeTargets targets;
        std::unique_ptr<Objects> objects;
        std::vector<rhi::BindingSet> bindings;  ///< By run.
        std::vector<TrackedTexture> sums;       ///< What one run leaves to the next.
        std::uint64_t last_used = 0;
    };
    /// The bindings anew, for another shadow map; to be used once the map is.
    [[nodiscard]] std::vector<Prepared> prepared_with(rhi::Texture shadow_map) const;
    void use(std::vector<Prepared> fresh) noexcept { prepared_ = std::move(fresh); }
    void release(const CompositeTargets& targets) noexcept;
    [[nodiscard]] bool prepared(const CompositeTargets& targets) noexcept { return find(targets) != nullptr; }
    /// `from_space`: the camera stands above the air.
    void record(rhi::CommandList& commands, const CompositeTargets& targets, bool from_space, std::uint64_t frame,
                PassReport& report, TimestampSlots timestamps, std::uint32_t index);

    static constexpr std::size_t max_prepared = 16;

private:
    [[nodiscard]] Prepared* find(const CompositeTargets& targets) noexcept;
    [[nodiscard]] bool draws(std::size_t run) const noexcept { return settings_.raster && run + 1 == runs_.size(); }
    [[nodiscard]] const rhi::Shader& shader(std::size_t run) const noexcept;
    [[nodiscard]] Specialize specialization(const TripletKernels& run, bool given_directions, bool from_space) const;
    void make_pipelines(bool given_directions);
    [[nodiscard]] Prepared bind(const CompositeTargets& targets, rhi::Texture shadow_map, std::uint64_t use) const;
    [[nodiscard]] rhi::BindingSet bind(const Prepared& prepared, std::size_t run, rhi::Texture shadow_map) const;
    [[nodiscard]] std::vector<rhi::Binding> tables(std::size_t run) const;

    ViewResources& shared_;
    const ModelKernels& kernels_;
    const ShadowPass& shadows_;
    CompositeSettings settings_;
    std::size_t ground_runs_;  // of ground_loss.comp.glsl, before the composite's own
    // Of ground_loss, and of a composite: one, or one for each triplet of wavelengths.
    std::vector<TripletKernels> runs_;
    // By run: of camera rays, of given directions (made when first prepared); the second of each where the kernel has a
    // ModelKernels::space_constant.
    std::vector<rhi::Pipeline> pipelines_[2][2];
    std::vector<Prepared> prepared_;
    std::uint64_t uses_ = 0;
};

}  // namespace aureole::detail
