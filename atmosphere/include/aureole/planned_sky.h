// A sky that follows its plan (plan.h): when the sun sets or the camera leaves the ground, another setting may be enough, or
// called for. update() says what changes; the new sky is made ready beside the old one, which gives way to it over some frames.
//
//     PlannedSky sky(device, needs, {.target_format = rhi::Format::rgba16_float});
//     sky.prepare_composite(targets);  // once for each set of textures
//     while (next_frame()) {
//         sky.set_frame(frame_number);  // a sky that has been given up dies after it
//         for (const PlanChange& change : sky.update(camera, suns).changes) log(change);
//         sky.record(commands);
//         sky.record_composite(commands, targets);
//     }
//
// Rules of Atmosphere and View hold (atmosphere.h): recording never allocates or throws; update() may do both when the plan
// changes, and then leaves everything as it was if it throws.
#pragma once

#include <aureole/plan.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace aureole {

/// How a planned sky follows sun and camera.
struct FollowSettings {
    /// A plan is kept until sun or camera have gone this far from where it was made, on the scales of asinh(sun elevation / 3
    /// degrees) and of asinh(30 altitude / thickness of the air); it is made for twice as far. In [0.01, 100].
    double margin = 0.5;
    /// Over which the old sky gives way to the new one, each an update after a recorded composite; 0: at once. In [0, 100000].
    std::uint32_t fade_frames = 30;
    /// Of Atmosphere::set_multi_scatter_passes_per_frame, in [0, 64]. A new sky's first tables are spread, too, of a model
    /// that takes seconds for them: the old one is shown meanwhile. The very first sky's are made at once. 0: all at once.
    int passes_per_frame = 1;
    /// Of every view, where PlanRequirements::shadows asks for them: cascades in [1, 4], the rest as ViewSettings::shadows.
    /// Else of no effect.
    ShadowSettings shadows{.cascades = 1};
};

/// Something that another plan does otherwise.
struct PlanChange {
    std::string what;           ///< As PlanChoice::what.
    std::string before, after;  ///< In words.
    std::string reason;         ///< Of the new plan.
};
/// What an update of a planned sky has done.
struct PlanUpdate {
    bool planned = false;             ///< A plan has been made; it may be the same as before.
    std::vector<PlanChange> changes;  ///< What it changes: empty if nothing.
    double share = 1;                 ///< Of the newest plan's sky in what will be shown: below 1 during a fade.
};

/// Light for a host's own materials, as View::light_table has it: `after` fades in by `share`. Textures live until the next
/// update().
struct PlannedLight {
    rhi::Texture before{};  ///< Null before the first record() and after invalidate() until the next, and where
                            ///< PlanRequirements::light is false.
    rhi::Texture after{};   ///< Null unless a new sky is fading in.
    double share = 0;       ///< Of `after`, in [0, 1].
};

/// An atmosphere with views that follows its plan: planned anew as sun and camera move, faded from one sky to the next.
class PlannedSky {
public:
    static constexpr std::size_t max_targets = 8;  ///< That are prepared at a time.

    /// The ranges of `needs` are those of the whole scene; each plan is for the part around sun and camera. The first plan is
    /// made by the first update(). `composite`: of every view. Throws as plan() does, and as View does for `composite`. Not for
    /// CompositeSettings::scene_depth without geometry, nor for PlanRequirements::views other than 1: a fade is that of one
    /// View's pictures, and cameras in different places may call for different plans. Several views: plan() for all of them, or
    /// a PlannedSky for each, which has its own tables of the air. Budgets are for one sky: during a fade there are two,
    /// and two pictures for each target.
    PlannedSky(rhi::Device& device, const PlanRequirements& needs, const CompositeSettings& composite = {},
               const FollowSettings& follow = {});
    ~PlannedSky();
    PlannedSky(const PlannedSky&) = delete;
    PlannedSky& operator=(const PlannedSky&) = delete;

    /// The frame's camera, and suns (at most PlanRequirements::suns): all that give light and are above -18 degrees are planned
    /// for, whichever is the brightest; if none is, one that is just there. Makes a new plan where they have left the
    /// surroundings of the last one, and a new sky where that differs. The setting in use stays while it meets the requirements
    /// and costs at most a tenth more than the best; a cheaper one has to do for twice as far around as a plan is made for. So
    /// a sun that goes to and fro does not make the sky do so. A sun or camera beyond the ranges of the
    /// requirements is planned for all the same. Until a new sky has faded in no other plan is made, and the old one is shown
    /// wherever the sun may have got to. Throws for bad input, and where the device refuses; then nothing has changed.
    PlanUpdate update(const Camera& camera, std::span<const Sun> suns);
    /// Of the latest update(). Before the first: that for the whole of the requirements' ranges.
    [[nodiscard]] const Plan& plan() const noexcept;
    /// Other air: planned for by the next update(), after a fade that is under way. Where the same setting is enough, as
    /// Atmosphere::set_parameters. Throws as plan() does, and then nothing has changed.
    void set_air(const AtmosphereParameters& air);
    /// As CompositeSettings::exposure, in [1e-30, 1e30]; anything else throws Error(invalid_argument) naming
    /// "composite.exposure", and then nothing has changed. Before the first update(): of the sky which that makes.
    void set_exposure(double exposure);
    /// As View::set_shadow_map, where PlanRequirements::shadows. Before the first update() there is no view to check a
    /// texture's use: such an error comes from there. If the device refuses during a fade, one of the two skies may have taken
    /// it: what was set before, and this, must live until another one is set.
    void set_shadow_map(const ShadowMap& map);
    void set_frame(std::uint64_t frame) noexcept;  ///< As Atmosphere's.

    /// As View's, but at most max_targets, which stay until they are released: before they are destroyed. Also makes two
    /// textures of the target's size and format for fades, unless FollowSettings::fade_frames is 0: the format must be one that
    /// can be sampled. Before the first update() there is no view to check a texture's use: such an error comes from there.
    void prepare_composite(const CompositeTargets& targets);
    void release_composite(const CompositeTargets& targets) noexcept;  ///< As View::release_composite.
    /// Records the tables of the air and the camera that are due. Before the first update(): nothing.
    void record(rhi::CommandList& commands);
    /// Records the composite; during a fade two of them, and one over the other. Before the first update() nothing but an error
    /// in the log.
    void record_composite(rhi::CommandList& commands, const CompositeTargets& targets);
    void invalidate() noexcept;  ///< As Atmosphere's. A fade begins anew.

    [[nodiscard]] PlannedLight light() const noexcept;         ///< Which light tables to read, and how to mix them.
    [[nodiscard]] std::uint64_t table_bytes() const noexcept;  ///< Of all skies there are at the moment; 0 before update().

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// What the second plan does otherwise than the first.
[[nodiscard]] std::vector<PlanChange> differences(const Plan& before, const Plan& after);

}  // namespace aureole
