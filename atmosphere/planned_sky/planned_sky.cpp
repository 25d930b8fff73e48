#include "plan/axes.h"
#include "planned_sky/crossfade.h"

#include "common/check.h"

#include <aureole/planned_sky.h>
#include <aureole/rhi/log.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace aureole {
namespace {

using namespace detail;

void check_follow(const FollowSettings& follow) {
    check("follow.margin", follow.margin, 0.01, 100);
    check("follow.fade_frames", follow.fade_frames, 0, 100000);
    check("follow.passes_per_frame", follow.passes_per_frame, 0, 64);
}

/// Where sun and camera are, on the scales of plan/axes.h.
struct Place {
    double sun = 0, altitude = 0;
};

/// Without suns, `before`'s: night changes nothing.
Place place_of(const Planet& planet, const Camera& camera, std::span<const Sun> suns, const Place& before) {
    const double distance = glm::length(camera.position_m);
    const glm::dvec3 up = distance > 0 ? camera.position_m / distance : glm::dvec3(0, 0, 1);
    Place place{before.sun, altitude_axis(std::max(distance - planet.bottom_radius_m, -1e4), planet)};
    if (suns.empty()) return place;
    const auto light = [](const Sun& sun) { return sun.irradiance.r + sun.irradiance.g + sun.irradiance.b; };
    const Sun& brightest = *std::ranges::max_element(suns, {}, light);
    const double sine = std::clamp(glm::dot(up, glm::normalize(brightest.direction)), -1.0, 1.0);
    place.sun = sun_axis(std::asin(sine) * 180 / std::numbers::pi);
    return place;
}

bool within(double value, double middle, double margin) { return std::abs(value - middle) <= margin; }

/// The part of a range that is within `margin` of a place on its axis, or the place itself where it is outside.
template <class ToAxis, class FromAxis>
PlanRange around(PlanRange range, double place, double margin, const ToAxis& to_axis, const FromAxis& from_axis) {
    const double least = to_axis(range.least), most = to_axis(range.most);
    const double low = std::max(place - margin, std::min(least, place)), high = std::min(place + margin, std::max(most, place));
    const auto back = [&](double on_axis) {
        if (on_axis == least) return range.least;
        return on_axis == most ? range.most : from_axis(on_axis);
    };
    return {back(low), back(high)};
}

PlanRequirements near(const PlanRequirements& needs, const Place& place, double margin) {
    const Planet& planet = needs.air.planet;
    PlanRequirements part = needs;
    part.sun_elevation_deg = around(needs.sun_elevation_deg, place.sun, margin, sun_axis, elevation_of);
    part.sun_elevation_deg.least = std::max(part.sun_elevation_deg.least, -90.0);
    part.sun_elevation_deg.most = std::min(part.sun_elevation_deg.most, 90.0);
    part.altitude_m = around(
        needs.altitude_m, place.altitude, margin, [&](double m) { return altitude_axis(m, planet); },
        [&](double on_axis) { return altitude_of(on_axis, planet); });
    part.altitude_m.least = std::clamp(part.altitude_m.least, -1e4, 1e12);
    part.altitude_m.most = std::clamp(part.altitude_m.most, part.altitude_m.least, 1e12);
    return part;
}

/// A plan, and what draws it.
struct Sky {
    Sky(rhi::Device& device, const Plan& plan_in, const CompositeSettings& composite, std::uint64_t frame, int passes_per_frame)
        : plan(plan_in), air(device, plan.air, plan.model), view(air, plan.view, composite) {
        air.set_frame(frame);
        if (passes_per_frame > 0) air.set_multi_scatter_passes_per_frame(passes_per_frame, true);
    }
    void record(rhi::CommandList& commands) {
        air.record(commands);
        if (air.progress() < 1) return;
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

bool same(const CompositeTargets& a, const CompositeTargets& b) {
    return a.scene_color == b.scene_color && a.scene_depth == b.scene_depth && a.target == b.target &&
           a.directions == b.directions && a.extent == b.extent;
}

}  // namespace

struct PlannedSky::Impl {
    Impl(rhi::Device& device_in, const PlanRequirements& needs_in, const CompositeSettings& composite_in,
         const FollowSettings& follow_in)
        : device(device_in), needs(needs_in), composite(composite_in), follow(follow_in) {
        check_follow(follow);
        first_plan = aureole::plan(needs);
        if (follow.fade_frames > 0) fade.emplace(device, frame, composite.target_format, composite.raster);
    }

    /// A new plan for this place, and a sky for it where it is another one. Throws and changes nothing.
    void plan_for(const Place& place, PlanUpdate& result) {
        const Plan fresh = aureole::plan(near(needs, place, follow.margin));
        result.planned = true;
        const std::vector<PlanChange> changes = current ? differences(current->plan, fresh) : std::vector<PlanChange>();
        if (current && fresh.setting == current->plan.setting) {
            if (redo) current->air.set_parameters(fresh.air);
            current->plan = fresh;
        } else {
            auto made = std::make_unique<Sky>(device, fresh, composite, frame, current ? follow.passes_per_frame : 0);
            for (const CompositeTargets& targets : prepared) prepare(*made, targets, current != nullptr);
            if (current)
                for (const CompositeTargets& targets : prepared) prepare_before(targets);
            (current ? next : current) = std::move(made);
            result.changes = changes;
            faded = 0;
        }
        planned_at = place;
        redo = false;
    }

    void prepare(Sky& sky, const CompositeTargets& targets, bool fades_in) {
        sky.view.prepare_composite(targets);
        if (fades_in && fade) sky.view.prepare_composite(into(targets, fade->pictures(targets.target).after));
    }
    void prepare_before(const CompositeTargets& targets) {
        if (fade) current->view.prepare_composite(into(targets, fade->pictures(targets.target).before));
    }

    [[nodiscard]] double share() const {
        if (!next) return 1;
        if (!next->ready) return 0;
        return follow.fade_frames == 0 ? 1 : static_cast<double>(faded) / follow.fade_frames;
    }

    /// A frame of the fade; at its end the new sky is the only one.
    void go_on() {
        if (!next || !next->ready) return;
        if (share() < 1) ++faded;
        if (share() >= 1) current = std::move(next);
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
    Place planned_at;
    bool redo = false;  // the air is another one
    std::uint32_t faded = 0;
};

PlannedSky::PlannedSky(rhi::Device& device, const PlanRequirements& needs, const CompositeSettings& composite,
                       const FollowSettings& follow)
    : impl_(std::make_unique<Impl>(device, needs, composite, follow)) {}
PlannedSky::~PlannedSky() = default;

PlanUpdate PlannedSky::update(const Camera& camera, std::span<const Sun> suns) {
    Impl& impl = *impl_;
    validate(camera);
    for (const Sun& sun : suns) validate(sun);
    check_count("suns", suns.size(), 0, impl.needs.suns);
    PlanUpdate result;
    const Place place = place_of(impl.needs.air.planet, camera, suns, impl.planned_at);
    const bool stays = within(place.sun, impl.planned_at.sun, impl.follow.margin) &&
                       within(place.altitude, impl.planned_at.altitude, impl.follow.margin);
    impl.go_on();
    if (!impl.current || (!impl.next && (impl.redo || !stays))) impl.plan_for(place, result);
    impl.current->view.update(camera, suns);
    if (impl.next) impl.next->view.update(camera, suns);
    result.share = impl.share();
    return result;
}

const Plan& PlannedSky::plan() const noexcept {
    if (impl_->next) return impl_->next->plan;
    return impl_->current ? impl_->current->plan : impl_->first_plan;
}

void PlannedSky::set_air(const AtmosphereParameters& air) {
    validate(air);
    if (air == impl_->needs.air) return;
    impl_->needs.air = air;
    impl_->redo = true;
}

void PlannedSky::set_exposure(double exposure) {
    check("composite.exposure", exposure, 1e-30, 1e30);
    impl_->composite.exposure = exposure;
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->view.set_exposure(exposure);
}

void PlannedSky::set_frame(std::uint64_t frame) noexcept {
    impl_->frame = frame;
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->air.set_frame(frame);
}

void PlannedSky::prepare_composite(const CompositeTargets& targets) {
    Impl& impl = *impl_;
    if (impl.fade) impl.fade->prepare(targets.target, targets.extent);
    if (impl.current) impl.prepare(*impl.current, targets, false);
    if (impl.next) {
        impl.prepare(*impl.next, targets, true);
        impl.prepare_before(targets);
    }
    if (std::ranges::none_of(impl.prepared, [&](const CompositeTargets& one) { return same(one, targets); }))
        impl.prepared.push_back(targets);
}

void PlannedSky::release_composite(const CompositeTargets& targets) noexcept {
    Impl& impl = *impl_;
    for (Sky* sky : {impl.current.get(), impl.next.get()}) {
        if (sky == nullptr) continue;
        sky->view.release_composite(targets);
        if (!impl.fade) continue;
        CrossfadePass::Pictures& pictures = impl.fade->pictures(targets.target);
        for (const TrackedTexture* picture : {&pictures.before, &pictures.after})
            sky->view.release_composite(into(targets, *picture));
    }
    if (std::erase_if(impl.prepared, [&](const CompositeTargets& one) { return same(one, targets); }) == 0 || !impl.fade)
        return;
    if (std::ranges::none_of(impl.prepared, [&](const CompositeTargets& one) { return one.target == targets.target; }))
        impl.fade->release(targets.target);
}

void PlannedSky::record(rhi::CommandList& commands) {
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) sky->record(commands);
}

void PlannedSky::record_composite(rhi::CommandList& commands, const CompositeTargets& targets) {
    Impl& impl = *impl_;
    if (!impl.current) {
        log()->error("PlannedSky::record_composite: called before PlannedSky::update; nothing is recorded");
        return;
    }
    const double share = impl.share();
    if (!impl.next || share <= 0 || !impl.fade) {
        impl.current->view.record_composite(commands, targets);
        return;
    }
    CrossfadePass::Pictures& pictures = impl.fade->pictures(targets.target);
    for (TrackedTexture* picture : {&pictures.before, &pictures.after}) move(commands, {{picture, impl.fade->written()}});
    impl.current->view.record_composite(commands, into(targets, pictures.before));
    impl.next->view.record_composite(commands, into(targets, pictures.after));
    impl.fade->record(commands, targets.target, share);
}

void PlannedSky::invalidate() noexcept {
    if (impl_->fade) impl_->fade->invalidate();
    for (Sky* sky : {impl_->current.get(), impl_->next.get()})
        if (sky != nullptr) {
            sky->air.invalidate();
            sky->ready = false;
        }
}

rhi::Texture PlannedSky::light_table() const noexcept {
    if (impl_->next && impl_->next->ready) return impl_->next->view.light_table();
    return impl_->current && impl_->current->ready ? impl_->current->view.light_table() : rhi::Texture{};
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
