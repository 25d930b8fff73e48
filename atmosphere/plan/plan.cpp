#include "plan/candidates.h"
#include "plan/choices.h"
#include "plan/keep.h"

#include "common/check.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace aureole {
namespace {

using namespace detail;

void check_range(const std::string& field, const PlanRange& range, double low, double high) {
    check(field + ".least", range.least, low, high);
    check(field + ".most", range.most, range.least, high);
}

/// Made once, when the first plan of its kind is.
const Predictor& predictor_for(const PlanRequirements& requirements) {
    if (requirements.wavelengths) {
        static const Predictor of_wavelengths(measured_in_wavelengths());
        return of_wavelengths;
    }
    static const Predictor of_rgb(measured_in_rgb());
    return of_rgb;
}

/// What the view makes is what is needed.
ViewSettings view_for(const PlanRequirements& requirements, AirBefore air) {
    ViewSettings view;
    view.projection = requirements.projection;
    view.max_suns = requirements.suns;
    view.aerial_perspective = air == AirBefore::drawn;
    view.aerial_perspective_distance_m = requirements.geometry_range_m;
    view.light = requirements.light;
    return view;
}

/// Cheapest first; what is excluded last, as it came.
std::vector<PlanCandidate> by_cost(std::vector<PlanCandidate> candidates) {
    std::ranges::stable_sort(candidates, [](const PlanCandidate& a, const PlanCandidate& b) {
        if (a.excluded.empty() != b.excluded.empty()) return a.excluded.empty();
        return a.cost.charged_ms < b.cost.charged_ms;
    });
    return candidates;
}

}  // namespace

void validate(const PlanRequirements& r) {
    validate(r.air);
    check_range("sun_elevation_deg", r.sun_elevation_deg, -90, 90);
    check_range("altitude_m", r.altitude_m, -1e4, 1e12);
    check_enum("projection", r.projection, Projection::fisheye, "matrix, panorama or fisheye");
    check("geometry_range_m", r.geometry_range_m, 1e-3, 1e13);
    check("suns", r.suns, 1, 4);
    check("views", r.views, 1, 64);
    check("width", r.width, 1, 65536);
    check("height", r.height, 1, 65536);
    check("rebuilds_per_frame", r.rebuilds_per_frame, 0, 1);
    check("speed.composite", r.speed.composite, 1e-6, 1e6);
    check("speed.tables", r.speed.tables, 1e-6, 1e6);
    if (r.tolerance) check("tolerance", *r.tolerance, 1e-4, 10);
    if (r.budget_ms) check("budget_ms", *r.budget_ms, 1e-9, 1e6);
    if (r.budget_mib) check("budget_mib", *r.budget_mib, 1e-9, 1e6);
    if (!r.tolerance && !r.budget_ms && !r.budget_mib)
        reject("tolerance", "nothing", "a tolerance, or a budget in milliseconds or MiB");
}

namespace {

/// Which of the candidates is taken, given the one that plan() takes.
using Take = std::function<const PlanCandidate&(const std::vector<PlanCandidate>&, const PlanCandidate& best)>;

Plan make_plan(const PlanRequirements& requirements, const Take& take, bool keep_air) {
    validate(requirements);
    const Predictor& predictor = predictor_for(requirements);
    const std::vector<Situation> places = situations_of(requirements, predictor.skies());
    Outlook seen = outlook(requirements, predictor, places, keep_air);
    Plan plan;
    plan.candidates = by_cost(seen.candidates);
    if (plan.candidates.empty() || !plan.candidates.front().excluded.empty())
        throw Error(ErrorCode::unsupported, requirements.wavelengths ? "wavelengths" : "air",
                    requirements.wavelengths ? "true" : "of these terms",
                    "what a setting was measured for; none can be taken: " + exclusions(plan.candidates));
    const PlanCandidate& best = plan.candidates[best_of(requirements, plan.candidates)];
    const PlanCandidate& taken = take(plan.candidates, best);
    plan.setting = taken.setting;
    plan.error = taken.error;
    plan.cost = taken.cost;
    plan.tolerable = taken.tolerable;
    Prepared prepared = prepare(taken.setting, requirements.air).value();
    plan.air = std::move(prepared.air);
    plan.model = std::move(prepared.model);
    plan.view = view_for(requirements, seen.air);
    if (requirements.shadows) plan.shadows_bound = shadows_bound(requirements, predictor, places);
    for (const std::size_t scene : seen.nearest) plan.nearest.push_back(predictor.skies().scenes[scene].id);
    plan.distance = seen.distance;
    plan.measured_on = predictor.skies().device;
    plan.speed = requirements.speed;
    plan.warnings = warnings_of(requirements, plan);
    plan.choices = choices_of(requirements, predictor, places.front(), seen, plan);
    if (!(taken.setting == best.setting))
        plan.choices.front().reason = "in use, and good enough; " + best.setting.id() + " would take " +
                                      milliseconds(best.cost.charged_ms) + " in place of " +
                                      milliseconds(taken.cost.charged_ms);
    return plan;
}

/// Not excluded; else `otherwise`.
const PlanCandidate& find(const std::vector<PlanCandidate>& candidates, const Setting& setting,
                          const PlanCandidate& otherwise) {
    const auto found = std::ranges::find(candidates, setting, &PlanCandidate::setting);
    return found == candidates.end() || !found->excluded.empty() ? otherwise : *found;
}

}  // namespace

Plan plan(const PlanRequirements& requirements) {
    const Take take_best = [](const auto&, const PlanCandidate& best) -> const PlanCandidate& { return best; };
    return make_plan(requirements, take_best, false);
}

namespace detail {

Plan plan_keeping(const PlanRequirements& requirements, const Setting& incumbent, bool keep_air) {
    const Take take = [&](const auto& candidates, const PlanCandidate& best) -> const PlanCandidate& {
        constexpr double worth = 1.1;  // what is better by less is not worth a change
        const PlanCandidate& there = find(candidates, incumbent, best);
        const bool as_cheap = there.cost.charged_ms <= worth * best.cost.charged_ms;
        const bool by_error = !requirements.tolerance || !best.tolerable;
        const bool as_right = !by_error || there.error.bound <= worth * best.error.bound;
        return there.tolerable == best.tolerable && as_cheap && as_right ? there : best;
    };
    return make_plan(requirements, take, keep_air);
}

Plan plan_of(const PlanRequirements& requirements, const Setting& setting, bool keep_air) {
    const Take take = [&](const auto& candidates, const PlanCandidate& best) -> const PlanCandidate& {
        return find(candidates, setting, best);
    };
    return make_plan(requirements, take, keep_air);
}

}  // namespace detail

Setting speed_setting() { return {}; }

DeviceSpeed calibrated(const SpeedSample& sample) {
    check("composite_ms", sample.composite_ms, 1e-9, 1e9);
    check("tables_ms", sample.tables_ms, 1e-9, 1e9);
    const MeasuredSkies& skies = measured_in_rgb();
    const auto air = static_cast<std::size_t>(std::ranges::find(skies.airs, "earth") - skies.airs.begin());
    const auto setting = std::ranges::find(skies.settings, speed_setting(), &MeasuredSetting::setting);
    if (air >= skies.airs.size() || setting == skies.settings.end() || setting->by_air.at(air).air_mib == 0)
        throw Error(ErrorCode::unsupported, "speed", speed_setting().id() + " in clear air", "what was measured");
    const MeasuredCost& known = setting->by_air[air];
    const double tables_ms = known.view_ms + known.aerial_perspective_ms + known.light_ms + known.rebuild_ms;
    const auto within = [](double factor) { return std::clamp(factor, 1e-6, 1e6); };
    return {within(sample.composite_ms / known.composite_ms), within(sample.tables_ms / tables_ms)};
}

}  // namespace aureole
