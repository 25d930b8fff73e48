#include "report/summary.h"

#include "app/quantile.h"

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <tuple>
#include <type_traits>

namespace aureole::app::report {
namespace {

using Results = std::vector<const MeasuredResult*>;

/// From the middle values alone: nothing is added to a last one that may be infinite.
double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return quantile(std::span<const double>(values).subspan((n - 1) / 2, n % 2 == 0 ? 2 : 1), 0.5);
}

/// By name: median of medians, greatest of the rest.
template <class List, class SpreadsOf>
auto over_scenes(const List& list, const SpreadsOf& spreads_of) {
    auto worst = std::decay_t<decltype(spreads_of(*list.front()))>();
    std::map<typename decltype(worst)::key_type, std::vector<double>> medians;
    for (const auto* one : list)
        for (const auto& [name, spread] : spreads_of(*one)) {
            medians[name].push_back(spread.median);
            Spread& so_far = worst[name];
            so_far.p95 = std::max(so_far.p95, spread.p95);
            so_far.max = std::max(so_far.max, spread.max);
        }
    for (auto& [name, spread] : worst) spread.median = median(medians[name]);
    return worst;
}

std::map<std::string, double> costs_of(const Measurements& all, std::size_t setting, const Results& results) {
    std::map<std::string, std::vector<double>> values;
    for (const MeasuredResult* result : results)
        for (const MeasuredCost& cost : all.costs)
            if (cost.setting == setting && cost.air == all.scenes[result->scene].air)
                for (const auto& [key, value] : cost.figures) values[key].push_back(value);
    std::map<std::string, double> costs;
    for (const auto& [key, list] : values) costs[key] = median(list);
    return costs;
}

Saving saving(double before, double after) {
    return {before - after, before > 0 ? std::optional((before - after) / before) : std::nullopt};
}

/// The froxels, and what the composite does for them.
std::optional<Saving> without_air(const std::map<std::string, double>& costs) {
    for (const char* key :
         {"per_frame_ms", "composite_ms", "composite_geometry_ms", "aerial_perspective_ms", "composite_bare_ms"})
        if (!costs.contains(key)) return {};
    const double tables = costs.at("per_frame_ms") - costs.at("composite_ms");
    return saving(tables + costs.at("composite_geometry_ms"),
                  tables - costs.at("aerial_perspective_ms") + costs.at("composite_bare_ms"));
}

Results only(const Results& results, const Results& scenes_of) {
    Results common;
    for (const MeasuredResult* result : results)
        if (std::any_of(scenes_of.begin(), scenes_of.end(), [&](const auto* other) { return other->scene == result->scene; }))
            common.push_back(result);
    return common;
}

std::optional<double> difference(double value, double from) {
    if (value > std::numeric_limits<double>::max() || from > std::numeric_limits<double>::max()) return {};
    return value - from;
}

/// Scene by scene, of medians and of 95th percentiles: the worst scene of both may be another than the one that loses most.
std::pair<std::optional<double>, std::optional<double>> added_in(const std::string& region, const Results& with,
                                                                 const Results& whole) {
    std::vector<double> medians, p95;
    for (const MeasuredResult* one : with)
        for (const MeasuredResult* other : whole) {
            if (other->scene != one->scene || !one->regions.contains(region) || !other->regions.contains(region)) continue;
            const Spread &here = one->regions.at(region), &there = other->regions.at(region);
            if (const auto added = difference(here.median, there.median)) medians.push_back(*added);
            if (const auto added = difference(here.p95, there.p95)) p95.push_back(*added);
        }
    std::pair<std::optional<double>, std::optional<double>> added;
    if (!medians.empty()) added.first = median(medians);
    if (!p95.empty()) added.second = *std::ranges::max_element(p95);
    return added;
}

Simplification compare(const Measurements& all, std::size_t setting, const Results& with, const Results& whole) {
    Simplification out{setting, *all.settings[setting].baseline, 0, {}, {}, {}, {}, {}};
    const Summary less = summarize(all, setting, only(with, whole)), more = summarize(all, out.baseline, only(whole, with));
    out.scenes = less.scenes;
    std::tie(out.added_median, out.added_p95) = added_in("all", only(with, whole), whole);
    std::tie(out.added_geometry_median, out.added_geometry_p95) = added_in("aerial", only(with, whole), whole);
    for (const auto& [key, cost] : more.costs)
        if (less.costs.contains(key)) out.saved[key] = saving(cost, less.costs.at(key));
    return out;
}

ClassSummary summarize_class(const Measurements& all, const std::string& name) {
    ClassSummary out;
    out.name = name;
    const auto in_class = [&](const MeasuredScene& scene) { return scene.scene_class == name; };
    out.scenes = static_cast<std::size_t>(std::count_if(all.scenes.begin(), all.scenes.end(), in_class));
    std::vector<const MeasuredScene*> scenes;
    for (const MeasuredScene& scene : all.scenes)
        if (in_class(scene)) scenes.push_back(&scene);
    out.bare = over_scenes(scenes, [](const MeasuredScene& scene) { return scene.bare; });
    std::vector<Results> of(all.settings.size());
    for (const MeasuredResult& result : all.results)
        if (in_class(all.scenes[result.scene])) of[result.setting].push_back(&result);
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (of[i].empty()) continue;
        out.settings.push_back(summarize(all, i, of[i]));
        std::map<double, Results> by_sun;
        for (const MeasuredResult* result : of[i]) by_sun[all.scenes[result->scene].sun_elevation_deg].push_back(result);
        for (const auto& [elevation, results] : by_sun) out.by_sun[elevation].push_back(summarize(all, i, results));
        const MeasuredSetting& setting = all.settings[i];
        if (setting.without.empty() || !setting.baseline) continue;
        const Simplification compared = compare(all, i, of[i], of[*setting.baseline]);
        if (compared.scenes > 0) out.simplifications.push_back(compared);
    }
    return out;
}

}  // namespace

Summary summarize(const Measurements& all, std::size_t setting, const Results& results) {
    Summary out{setting, results.size(), {}, {}, {}, {}, {}};
    out.regions = over_scenes(results, [](const MeasuredResult& of) { return of.regions; });
    std::set<std::string> what;
    for (const MeasuredResult* result : results)
        for (const auto& [name, parts] : result->split) what.insert(name);
    for (const std::string& name : what)
        out.split[name] = over_scenes(results, [&](const MeasuredResult& of) {
            const auto found = of.split.find(name);
            return found == of.split.end() ? std::map<std::string, Spread>{} : found->second;
        });
    for (const MeasuredResult* result : results)
        for (const auto& [key, error] : result->figures) {
            double& worst = out.errors[key];
            worst = std::max(worst, error);
        }
    out.costs = costs_of(all, setting, results);
    out.without_air = without_air(out.costs);
    return out;
}

std::vector<ClassSummary> summarize(const Measurements& all) {
    std::vector<std::string> names;
    for (const MeasuredScene& scene : all.scenes)
        if (std::find(names.begin(), names.end(), scene.scene_class) == names.end()) names.push_back(scene.scene_class);
    std::vector<ClassSummary> classes;
    classes.reserve(names.size());
    for (const std::string& name : names) classes.push_back(summarize_class(all, name));
    return classes;
}

}  // namespace aureole::app::report
