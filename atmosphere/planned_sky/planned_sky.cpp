#include "composite/composite.h"
#include "module/requirements.h"
#include "module/told.h"
#include "plan/keep.h"
#include "planned_sky/crossfade.h"
#include "planned_sky/place.h"
#include "shadows/shadows.h"

#include "common/check.h"

#include <aureole/planned_sky.h>
#include <aureole/rhi/log.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace aureole {
namespace {

using namespace detail;

void check_follow(const FollowSettings& follow, bool shadows) {
    check("follow.margin", follow.margin, 0.01, 100);
    check("follow.fade_frames", follow.fade_frames, 0, 100000);
    check("follow.passes_per_frame", follow.passes_per_frame, 0, 64);
    if (!shadows) return;
    check("follow.shadows.cascades", follow.shadows.cascades, 1, ShadowSettings::max_cascades);
    detail::validate(follow.shadows);
}

/// A plan, and what draws it.
struct Sky {
    Sky(rhi::Device& device, const Plan& plan_in, const CompositeSettings& composite, const ShadowSettings& shadows,
        std::uint64_t frame)
        : plan(plan_in), air(device, plan.air, plan.model), view(air, with(plan.view, shadows), composite) {
        air.set_frame(frame);
    }
    [[nodiscard]] static ViewSettings with(ViewSettings view, const ShadowSettings& shadows) {
        view.shadows = shadows;
        return view;
    }
    void record(rhi::CommandList& commands) {
        air.record(commands);
        if (!ready && air.progress() < 1) return;
        view.record(commands);
        ready = true;
    }
    Plan plan;
    Atmosphere air;
    View view;
    bool ready = false;  // its tables have been recorded
};

CompositeTargets into(CompositeTargets targets, const TrackedTexture& picture) {
    targets.target = picture.handle;
    return targets;
}

void check_together(const PlanRequirements& needs, const CompositeSettings& composite) {
    if (needs.views != 1) reject("views", std::to_string(needs.views), "1 for a PlannedSky, which draws one");
    if (composite.scene_depth && !needs.geometry)
        reject("composite.scene_depth", "true", "false without PlanRequirements::geometry");
}

}  // namespace

struct PlannedSky::Impl {
    Impl(rhi::Device& device_in, const PlanRequirements& needs_in, const CompositeSettings& composite_in,
         const FollowSettings& follow_in)
        : device(device_in), needs(needs_in), composite(composite_in), follow(follow_in) {
        check_follow(follow, needs.shadows);
        if (!needs.shadows) follow.shadows = {};
        detail::validate(composite);
        require_target(device, composite);
        check_together(needs, composite);
        first_plan = aureole::plan(needs);
        prepared.reserve(max_targets);
        if (follow.fade_frames > 0) fade.emplace(device, frame, composite.target_format, composite.raster);
    }

    void check_inputs(const Camera& camera, std::span<const Sun> suns) const {
        validate(camera);
        if (camera.kind != needs.projection) reject("camera.kind", "another", "that of PlanRequirements::projection");
        for (const Sun& sun : suns) validate(sun);
        check_count("suns", suns.size(), 0, needs.suns);
    }

    /// What an update is about to change; nothing has been changed yet.
    struct Next {
        bool promoted = false;  // the sky that has been fading in is the only one from here on
        std::uint32_t faded = 0;
        Plan plan;                 // with update.planned
        std::unique_ptr<Sky> sky;  // for that plan, if it is another setting
        PlanUpdate update;
    };

    [[nodiscard]] Next think(const Place& place) {
        Next result;
        result.faded = faded + (next && next->ready && shown_since ? 1 : 0);
        result.promoted = next && next->ready && result.faded >= follow.fade_frames && shown_since;
        Sky* stays = result.promoted ? next.get() : current.get();
        const bool here = near(place, planned_at, follow.margin);
        if (stays != nullptr && (next || (here && !redo))) return result;
        result.plan = plan_for(place, stays);
        result.update.planned = true;
        if (stays != nullptr) result.update.changes = differences(stays->plan, result.plan);
        if (stays == nullptr || !drawn_alike(result.plan, stays->plan))
            result.sky = std::make_unique<Sky>(device, result.plan, composite, follow.shadows, frame);
        return result;
    }

    [[nodiscard]] static bool drawn_alike(const Plan& a, const Plan& b) {
        return a.setting == b.setting && a.view.aerial_perspective == b.view.aerial_perspective;
    }

    /// Twice as wide as it is left: it holds while the next one is made ready. What there is stays while it is good enough, and
    /// as cheap within a tenth. Something cheaper must hold four margins around, so that what wobbles about a boundary by
    /// two does not go to and fro: another setting, and geometry without the air before it.
    [[nodiscard]] Plan plan_for(const Place& place, const Sky* stays) const {
        const PlanRequirements part = around(needs, place, 2 * follow.margin);
        if (stays == nullptr) return aureole::plan(part);
        const Setting& incumbent = stays->plan.setting;
        Plan found = plan_keeping(part, incumbent);
        const bool drops_air = stays->plan.view.aerial_perspective && !found.view.aerial_perspective;
        if (!drops_air && (found.setting == incumbent || !meets(found, incumbent))) return found;
        const Plan wider = aureole::plan(around(needs, place, 4 * follow.margin));
        const bool keep_air = drops_air && wider.view.aerial_perspective;
        if (keep_air) found = plan_keeping(part, incumbent, true);
        if (found.setting == incumbent || !meets(found, incumbent)) return found;
        return meets(wider, found.setting) ? found : plan_of(part, incumbent, keep_air);
    }
    [[nodiscard]] static bool meets(const Plan& plan, const Setting& setting) {
        const auto found = std::ranges::find(plan.candidates, setting, &PlanCandidate::setting);
        return found != plan.candidates.end() && found->tolerable;
    }

    /// Everything of the device that it takes. May throw; what is left then does no harm.
    void make_ready(Next& to, const Camera& camera, std::span<const Sun> suns) {
        Sky* stays = to.promoted ? next.get() : current.get();
        if (to.promoted) stays->air.set_multi_scatter_passes_per_frame(follow.passes_per_frame);
        if (to.sky) {
            const bool fades_in = stays != nullptr && fade.has_value();
            to.sky->air.set_multi_scatter_passes_per_frame(follow.passes_per_frame,
                                                           stays != nullptr && follow.passes_per_frame > 0);
            for (const CompositeTargets& targets : prepared) {
                prepare(*to.sky, targets, fades_in ? &CrossfadePass::Pictures::after : nullptr);
                if (fades_in) prepare(*stays, targets, &CrossfadePass::Pictures::before);
            }
            if (shadow_map) to.sky->view.set_shadow_map(*shadow_map);
            to.sky->view.update(camera, suns);
        }
        if (to.update.planned && !to.sky) stays->air.set_parameters(to.plan.air);
        // Inputs are checked: nothing throws from here on.
        for (Sky* sky : {current.get(), next.get()})
            if (sky != nullptr && (sky != current.get() || !to.promoted)) sky->view.update(camera, suns);
    }

    void commit(Next& to, const Place& place) noexcept {
        faded = to.faded;
        shown_since = false;
        if (to.promoted) {
            current = std::move(next);
            if (fade)
                for (const CompositeTargets& targets : prepared)
                    if (const auto* pictures = fade->pictures(targets.target))
                        current->view.release_composite(into(targets, pictures->after));
        }
        if (!to.update.planned) return;
        planned_at = place;
        redo = false;
        if (!to.sky) {
            current->plan = std::move(to.plan);
            return;
        }
        (current ? next : current) = std::move(to.sky);
        faded = 0;
    }

    void prepare(Sky& sky, const CompositeTargets& targets, TrackedTexture CrossfadePass::Pictures::*picture) {
        sky.view.prepare_composite(targets);
        if (picture != nullptr) sky.view.prepare_composite(into(targets, fade->pictures(targets.target)->*picture));
    }
    /// In all skies there are.
    void prepare(const CompositeTargets& targets) {
        if (current) prepare(*current, targets, next && fade ? &CrossfadePass::Pictures::before : nullptr);
        if (next) prepare(*next, targets, fade ? &CrossfadePass::Pictures::after : nullptr);
    }

    void forget_targets(const CompositeTargets& targets) noexcept {
        const CrossfadePass::Pictures* pictures = fade ? fade->pictures(targets.target) : nullptr;
        for (Sky* sky : {current.get(), next.get()}) {
            if (sky == nullptr) continue;
            sky->view.release_composite(targets);
            if (pictures == nullptr) continue;
            for (const TrackedTexture* picture : {&pictures->before, &pictures->after})
                sky->view.release_composite(into(targets, *picture));
        }
    }

    [[nodiscard]] double share() const noexcept {
        if (!next) return 1;
        if (!next->ready || follow.fade_frames == 0) return 0;
        return static_cast<double>(faded) / follow.fade_frames;
    }

    rhi::Device& device;
    PlanRequirements needs;
    CompositeSettings composite;
    FollowSettings follow;
    std::uint64_t frame = 0;
    Plan first_plan;
    std::optional<CrossfadePass> fade;
    std::unique_ptr<Sky> current, next;
    std::vector<CompositeTargets> prepared;
    std::optional<ShadowMap> shadow_map;
    Place planned_at;
    bool redo = false;  // the air is another one
    detail::Told before_update;
    bool shown_since = false;  // a composite has been recorded since the last update
    std::uint32_t faded = 0;
};

PlannedSky::PlannedSky(rhi::Device& device, const PlanRequirements& needs, const CompositeSettings& composite,
                       const FollowSettings& follow)
    : impl_(std::make_unique<Impl>(device, needs, composite, follow)) {}
PlannedSky::~PlannedSky() = default;

PlanUpdate PlannedSky::update(const Camera& camera, std::span<const Sun> suns) {
    Impl& impl = *impl_;
    impl.check_inputs(camera, suns);
    const Place place = place_of(impl.needs.air.planet, camera, suns, impl.planned_at);
    Impl::Next next = impl.think(place);
    impl.make_ready(next, camera, suns);
    impl.commit(next, place);
    next.update.share = impl.share();
    return std::move(next.update);
}

const Plan& PlannedSky::plan() const noexcept {
    if (impl_->next) return impl_->next->plan;
    return impl_->current ? impl_->current->plan : impl_->first_plan;
}

void PlannedSky::set_air(const AtmosphereParameters& air) {
    PlanRequirements needs = impl_->needs;
    needs.air = air;
    if (air == impl_->needs.air) return;
    Plan whole = aureole::plan(needs);  // throws where there is none
    impl_->first_plan = std::move(whole);
    impl_->needs = std::move(needs);
    impl_->redo = true;
}

void PlannedSky::set_exposure(double exposure) {
    check("composite.exposure", exposure, 1e-30, 1e30);
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->view.set_exposure(exposure);
    impl_->composite.exposure = exposure;
}

void PlannedSky::set_shadow_map(const ShadowMap& map) {
    Impl& impl = *impl_;
    detail::validate(map, impl.follow.shadows, impl.needs.suns, impl.device);
    for (Sky* sky : {impl.current.get(), impl.next.get()})
        if (sky != nullptr) sky->view.set_shadow_map(map);
    impl.shadow_map = map;
}

void PlannedSky::set_frame(std::uint64_t frame) noexcept {
    impl_->frame = frame;
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->air.set_frame(frame);
}

void PlannedSky::prepare_composite(const CompositeTargets& targets) {
    Impl& impl = *impl_;
    check_targets(impl.device, impl.composite, false, targets);
    const bool known = std::ranges::find(impl.prepared, targets) != impl.prepared.end();
    if (!known && impl.prepared.size() == max_targets)
        reject("targets", std::to_string(max_targets + 1),
               "at most " + std::to_string(max_targets) + " prepared at a time; release_composite gives them up");
    const bool made = impl.fade && impl.fade->prepare(targets.target, targets.extent);
    try {
        impl.prepare(targets);
    } catch (...) {
        if (!known) impl.forget_targets(targets);
        if (made) impl.fade->release(targets.target);
        throw;
    }
    if (!known) impl.prepared.push_back(targets);
}

void PlannedSky::release_composite(const CompositeTargets& targets) noexcept {
    Impl& impl = *impl_;
    if (std::erase(impl.prepared, targets) == 0) return;
    impl.forget_targets(targets);
    if (impl.fade && std::ranges::none_of(impl.prepared, [&](const auto& one) { return one.target == targets.target; }))
        impl.fade->release(targets.target);
}

void PlannedSky::record(rhi::CommandList& commands) {
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->record(commands);
}

void PlannedSky::record_composite(rhi::CommandList& commands, const CompositeTargets& targets) {
    Impl& impl = *impl_;
    if (impl.before_update.begins(!impl.current))
        log()->error("PlannedSky::record_composite: called before PlannedSky::update; nothing is recorded");
    if (!impl.current) return;
    impl.shown_since = true;
    const double share = impl.share();
    const bool known = std::ranges::find(impl.prepared, targets) != impl.prepared.end();
    CrossfadePass::Pictures* pictures = impl.fade && known ? impl.fade->pictures(targets.target) : nullptr;
    if (!impl.next || share <= 0 || pictures == nullptr) {
        impl.current->view.record_composite(commands, targets);
        return;
    }
    move(commands, {{&pictures->before, impl.fade->written()}, {&pictures->after, impl.fade->written()}});
    impl.current->view.record_composite(commands, into(targets, pictures->before));
    impl.next->view.record_composite(commands, into(targets, pictures->after));
    impl.fade->record(commands, targets.target, share);
}

void PlannedSky::invalidate() noexcept {
    if (impl_->fade) impl_->fade->invalidate();
    impl_->faded = 0;  // where a new sky has to be made ready again, it fades in again
    impl_->shown_since = false;
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) {
            sky->air.invalidate();
            sky->ready = false;
        }
}

PlannedLight PlannedSky::light() const noexcept {
    const Impl& impl = *impl_;
    const auto table = [](const std::unique_ptr<Sky>& sky) {
        return sky && sky->ready ? sky->view.light_table() : rhi::Texture{};
    };
    const bool fading = impl.next && impl.next->ready;
    return {table(impl.current), fading ? table(impl.next) : rhi::Texture{}, fading ? impl.share() : 0};
}

std::uint64_t PlannedSky::table_bytes() const noexcept {
    std::uint64_t bytes = 0;
    for (const Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) bytes += sky->air.table_bytes() + sky->view.table_bytes();
    return bytes;
}

std::vector<PlanChange> differences(const Plan& before, const Plan& after) {
    std::vector<PlanChange> changes;
    const auto chosen = [](const Plan& plan, const std::string& what) {
        const auto found = std::ranges::find(plan.choices, what, &PlanChoice::what);
        return found == plan.choices.end() ? std::string() : found->chosen;
    };
    for (const PlanChoice& choice : after.choices)
        if (const std::string old = chosen(before, choice.what); old != choice.chosen)
            changes.push_back({choice.what, old, choice.chosen, choice.reason});
    for (const PlanChoice& choice : before.choices)
        if (chosen(after, choice.what).empty()) changes.push_back({choice.what, choice.chosen, {}, "not of this model"});
    return changes;
}

}  // namespace aureole
