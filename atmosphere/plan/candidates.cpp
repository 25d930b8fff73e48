#include "plan/candidates.h"

#include "plan/axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace aureole::detail {
namespace {

constexpr double measured_pixels = double(measured_width) * measured_height;
constexpr double alike = 1.1;  // costs, or errors, that differ by less are the same
constexpr int sun_steps = 8, altitude_steps = 4;
constexpr std::size_t nearest_named = 3;

bool inside(const PlanRange& range, double value) { return range.least <= value && value <= range.most; }

/// `steps` + 1 places from one end to the other, evenly in `warp`; one if both ends are the same.
template <class Warp, class Unwarp>
std::vector<double> spread_over(PlanRange range, int steps, const Warp& warp, const Unwarp& unwarp) {
    if (range.least == range.most) return {range.least};
    std::vector<double> result;
    const double first = warp(range.least), last = warp(range.most);
    for (int i = 0; i <= steps; ++i) result.push_back(unwarp(first + (last - first) * i / steps));
    result.front() = range.least;
    result.back() = range.most;
    return result;
}

std::string why_excluded(const PlanRequirements& requirements, const std::optional<Prepared>& prepared) {
    if (!prepared) return "leaves out what this air does not have";
    if (requirements.shadows && !prepared->model->has_shadows()) return "has no shadows in the air";
    return {};
}

/// Of those that `counts`, the least by `first`; of those alike in it the least by `second`.
template <class Counts, class First, class Second>
std::optional<std::size_t> least(const std::vector<PlanCandidate>& candidates, const Counts& counts, const First& first,
                                 const Second& second) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const PlanCandidate& one : candidates)
        if (one.excluded.empty() && counts(one)) smallest = std::min(smallest, first(one));
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const PlanCandidate& one = candidates[i];
        if (!one.excluded.empty() || !counts(one) || first(one) > alike * smallest) continue;
        if (!best || second(one) < second(candidates[*best])) best = i;
    }
    return best;
}

/// A composite under one sun.
double shown_ms(const MeasuredCost& measured, AirBefore air) {
    if (air == AirBefore::nothing) return measured.composite_ms;
    const bool bare = air == AirBefore::left_out && measured.composite_bare_ms > 0;
    return bare ? measured.composite_bare_ms : measured.composite_geometry_ms;
}

/// Of sky and light, as `worse` says.
std::optional<PlanError> worse_beside_geometry(const PlanRequirements& requirements, const MeasuredSetting& setting,
                                               Predictor::Here& here, const PlanError& so_far) {
    PlanError worst = so_far;
    const std::optional<PredictedError> median = here.predict(setting.sky_median);
    const std::optional<PredictedError> sky = here.predict(setting.sky_p95);
    if (!median || !sky) return {};
    worst.median = std::max(worst.median, median->likely);
    worst.p95 = std::max(worst.p95, sky->likely);
    worst.bound = std::max(worst.bound, sky->bound);
    if (requirements.light && here.predictor().knows_light() && !here.above_air()) {
        const std::optional<PredictedError> light = here.predict(setting.light);
        if (!light) return {};
        worst.light = std::max(worst.light, light->likely);
        worst.bound = std::max(worst.bound, light->bound);
    }
    return worst;
}

/// Of geometry as far as it may be.
std::optional<PredictedError> through_air(const PlanRequirements& requirements, const MeasuredSetting& setting,
                                          Predictor::Here& here) {
    PredictedError worst;
    for (const MeasuredError* error : errors_of_geometry(setting, requirements.geometry_range_m)) {
        if (error == nullptr) continue;
        const std::optional<PredictedError> found = here.predict(*error);
        if (!found) return {};
        worst = {std::max(worst.likely, found->likely), std::max(worst.bound, found->bound)};
    }
    return worst;
}

std::optional<PredictedError> worst_bare(const PlanRequirements& requirements, const Predictor& predictor,
                                         const std::vector<Situation>& places) {
    PredictedError worst;
    const double densest = densest_extinction_per_m(requirements.air);
    for (const Situation& place : places) {
        const auto here = predictor.at(place).bare(requirements.geometry_range_m, densest);
        if (!here) return {};
        worst = {std::max(worst.likely, here->likely), std::max(worst.bound, here->bound)};
    }
    return worst;
}

}  // namespace

AirBefore choose_air(const PlanRequirements& requirements, const std::optional<PredictedError>& bare, bool keep_air) {
    const bool within = bare && requirements.tolerance && bare->bound <= *requirements.tolerance;
    if (within && !requirements.shadows && !keep_air) return AirBefore::left_out;
    return air_asked_for(requirements);
}

PlanError worse_of(PlanError error, const PredictedError& geometry) {
    error.p95 = std::max(error.p95, geometry.likely);
    error.bound = std::max(error.bound, geometry.bound);
    return error;
}

std::vector<Situation> situations_of(const PlanRequirements& requirements, const MeasuredSkies& skies) {
    const AirCoordinates air(requirements.air);
    const Planet& planet = requirements.air.planet;
    const auto suns = spread_over(requirements.sun_elevation_deg, sun_steps, sun_axis, elevation_of);
    const auto altitudes = spread_over(
        requirements.altitude_m, altitude_steps, [&](double m) { return altitude_axis(m, planet); },
        [&](double on_axis) { return altitude_of(on_axis, planet); });
    std::set<std::pair<double, double>> places;
    const auto add = [&](double sun, std::span<const double> heights) {
        for (const double altitude : heights) places.emplace(sun, altitude);
    };
    for (const double sun : suns) add(sun, altitudes);
    // What was measured worst is not passed over: where it was measured, nor at another altitude or hour.
    for (const MeasuredScene& scene : skies.scenes) {
        const bool hour = inside(requirements.sun_elevation_deg, scene.sun_elevation_deg);
        const bool height = inside(requirements.altitude_m, scene.altitude_m);
        if (hour) add(scene.sun_elevation_deg, altitudes);
        if (hour && height) places.emplace(scene.sun_elevation_deg, scene.altitude_m);
        if (height)
            for (const double sun : suns) places.emplace(sun, scene.altitude_m);
    }
    std::vector<Situation> result;
    result.reserve(places.size());
    for (const auto& [sun, altitude] : places) result.push_back(air.at(sun, altitude));
    return result;
}

std::optional<PlanError> worse(const PlanRequirements& requirements, const MeasuredSetting& setting, Predictor::Here& here,
                               const PlanError& so_far) {
    std::optional<PlanError> worst = worse_beside_geometry(requirements, setting, here, so_far);
    if (!worst || !requirements.geometry) return worst;
    const std::optional<PredictedError> through = through_air(requirements, setting, here);
    if (!through) return {};
    return worse_of(*worst, *through);
}

std::optional<double> measured_worst(const PlanRequirements& requirements, const MeasuredSetting& setting, std::size_t scene) {
    double worst = 0;
    const auto take = [&](const MeasuredError& error) {
        const std::optional<double> truth = error.in(scene);
        worst = std::max(worst, truth.value_or(0));
        return truth.has_value();
    };
    bool known = take(setting.sky_p95) && (!requirements.light || take(setting.light));
    if (!requirements.geometry) return known ? std::optional(worst) : std::nullopt;
    for (const MeasuredError* error : errors_of_geometry(setting, requirements.geometry_range_m))
        known &= error == nullptr || take(*error);
    return known ? std::optional(worst) : std::nullopt;
}

bool tolerates(const PlanRequirements& requirements, const PlanCandidate& candidate) {
    return (!requirements.tolerance || candidate.error.bound <= *requirements.tolerance) &&
           (!requirements.budget_ms || candidate.cost.charged_ms <= *requirements.budget_ms) &&
           (!requirements.budget_mib || candidate.cost.mebibytes <= *requirements.budget_mib);
}

CostParts cost_of(const PlanRequirements& requirements, const MeasuredCost& measured, AirBefore air) {
    const double views = requirements.views, suns = requirements.suns;
    const double pixels = double(requirements.width) * requirements.height / measured_pixels;
    const auto [composite, tables] = requirements.speed;
    CostParts parts;
    const bool drawn = air == AirBefore::drawn;
    parts.aerial_perspective_ms = drawn ? views * suns * tables * measured.aerial_perspective_ms : 0;
    parts.light_ms = requirements.light ? views * suns * tables * measured.light_ms : 0;
    if (requirements.shadows)  // of one sun
        parts.shadows_ms = views * (tables * measured.shadows_ms + composite * pixels * measured.composite_shadows_ms);
    const double shown = shown_ms(measured, air) + (suns - 1) * measured.composite_sun_ms;
    parts.cost.frame_ms = views * (composite * pixels * shown + suns * tables * measured.view_ms) +
                          parts.aerial_perspective_ms + parts.light_ms + parts.shadows_ms;
    parts.cost.rebuild_ms = tables * measured.rebuild_ms;
    const double aerial_mib = drawn ? measured.aerial_perspective_mib : 0;
    parts.cost.mebibytes = measured.air_mib + views * suns * (measured.view_mib + aerial_mib);
    if (requirements.shadows) parts.cost.mebibytes += views * measured.shadows_mib;
    parts.cost.charged_ms = parts.cost.frame_ms + requirements.rebuilds_per_frame * parts.cost.rebuild_ms;
    return parts;
}

namespace {

/// Costs alone; the air is the same everywhere.
PlanCandidate candidate_of(const PlanRequirements& requirements, const MeasuredSetting& measured, const Predictor& predictor,
                           const Situation& place, AirBefore air) {
    PlanCandidate candidate;
    candidate.setting = measured.setting;
    const std::optional<Prepared> prepared = prepare(measured.setting, requirements.air);
    candidate.excluded = why_excluded(requirements, prepared);
    if (!candidate.excluded.empty()) return candidate;
    const auto cost = predictor.cost(measured, place, table_work(*prepared->model, prepared->air));
    if (cost)
        candidate.cost = cost_of(requirements, *cost, air).cost;
    else
        candidate.excluded = "was not measured";
    return candidate;
}

/// What one setting errs by so far, in all the places that have been looked at: none where one of them is not known.
struct Errors {
    std::optional<PlanError> beside = PlanError();  // sky and light
    std::optional<PredictedError> through = PredictedError();

    void look(const PlanRequirements& requirements, const MeasuredSetting& setting, Predictor::Here& here) {
        if (!beside) return;
        beside = worse_beside_geometry(requirements, setting, here, *beside);
        if (!requirements.geometry || !through) return;
        const auto found = through_air(requirements, setting, here);
        if (found)
            through = {std::max(through->likely, found->likely), std::max(through->bound, found->bound)};
        else
            through.reset();
    }
    [[nodiscard]] std::optional<PlanError> with_air(AirBefore air, const std::optional<PredictedError>& bare) const {
        if (!beside || air == AirBefore::nothing) return beside;
        const std::optional<PredictedError>& geometry = air == AirBefore::drawn ? through : bare;
        return geometry ? std::optional(worse_of(*beside, *geometry)) : std::nullopt;
    }
};

}  // namespace

Outlook outlook(const PlanRequirements& requirements, const Predictor& predictor, const std::vector<Situation>& places,
                bool keep_air) {
    const std::vector<MeasuredSetting>& settings = predictor.skies().settings;
    Outlook result;
    if (requirements.geometry) result.bare = worst_bare(requirements, predictor, places);
    result.air = choose_air(requirements, result.bare, keep_air);
    for (const MeasuredSetting& setting : settings)
        result.candidates.push_back(candidate_of(requirements, setting, predictor, places.front(), result.air));
    std::vector<Errors> errors(settings.size());
    const Situation* farthest = &places.front();
    for (const Situation& place : places) {
        Predictor::Here here = predictor.at(place);
        if (const double distance = here.distance(); distance > result.distance) {
            result.distance = distance;
            farthest = &place;
        }
        for (std::size_t i = 0; i < settings.size(); ++i)
            if (result.candidates[i].excluded.empty()) errors[i].look(requirements, settings[i], here);
    }
    result.nearest = predictor.at(*farthest).nearest(nearest_named);
    const AirBefore other = result.air == AirBefore::drawn ? AirBefore::left_out : AirBefore::drawn;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        PlanCandidate& candidate = result.candidates[i];
        const auto error = errors[i].with_air(result.air, result.bare), otherwise = errors[i].with_air(other, result.bare);
        result.bound_otherwise.push_back(otherwise ? std::optional(otherwise->bound) : std::nullopt);
        if (candidate.excluded.empty() && !error) candidate = {settings[i].setting, {}, {}, false, "was not measured"};
        if (!candidate.excluded.empty()) continue;
        candidate.error = *error;
        candidate.tolerable = tolerates(requirements, candidate);
    }
    return result;
}

std::size_t best_of(const PlanRequirements& requirements, const std::vector<PlanCandidate>& candidates) {
    const auto cost = [](const PlanCandidate& one) { return one.cost.charged_ms; };
    const auto error = [](const PlanCandidate& one) { return one.error.bound; };
    const auto tolerable = [](const PlanCandidate& one) { return one.tolerable; };
    // By how much it breaks the budget that it breaks most; up to 1: it keeps them.
    const auto excess = [&](const PlanCandidate& one) {
        return std::max(requirements.budget_ms ? one.cost.charged_ms / *requirements.budget_ms : 0.0,
                        requirements.budget_mib ? one.cost.mebibytes / *requirements.budget_mib : 0.0);
    };
    const auto affordable = [&](const PlanCandidate& one) { return excess(one) <= 1; };
    const auto any = [](const PlanCandidate&) { return true; };
    const auto best = requirements.tolerance ? least(candidates, tolerable, cost, error) : std::nullopt;
    if (best) return *best;
    if (const auto accurate = least(candidates, affordable, error, cost)) return *accurate;
    return least(candidates, any, excess, error).value();
}

}  // namespace aureole::detail
