#include "measure/hold_out.h"

#include "app/fnv.h"
#include "app/quantile.h"
#include "measure/fit.h"
#include "plan/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace aureole::app {
namespace {

using detail::MeasuredCost;
using detail::MeasuredError;
using detail::MeasuredSetting;
using detail::MeasuredSkies;
using detail::Predictor;

constexpr std::array tolerances{0.005, 0.01, 0.02, 0.05, 0.1, 0.2};
/// As far as geometry goes in choices: there is none, it is near, and as far as a view's froxels by default.
constexpr std::array geometry_km{0.0, 0.0316, 0.316, 3.16, 96.0};

std::uint64_t hash_of(const std::string& text, std::uint32_t seed) {
    Fnv1a hash;
    hash.add(seed);
    hash.add(text);
    return hash.value() ^ hash.value() >> 32;
}

std::vector<std::size_t> all_but(std::size_t count, const std::vector<std::size_t>& sorted) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < count; ++i)
        if (!std::ranges::binary_search(sorted, i)) result.push_back(i);
    return result;
}

/// An error beside what was measured.
struct Foretold {
    double excess, off;  // Coverage::Of
};

Coverage::Of summary_of(const std::vector<Foretold>& list) {
    if (list.empty()) return {};
    std::vector<double> excess, off;
    for (const Foretold& one : list) {
        excess.push_back(one.excess);
        off.push_back(one.off);
    }
    std::ranges::sort(excess);
    std::ranges::sort(off);
    const auto below = std::ranges::count_if(excess, [](double e) { return e >= 1; });
    return {list.size(), static_cast<double>(below) / static_cast<double>(list.size()), quantile(excess, 0.5),
            quantile(off, 0.5)};
}

/// Predictions in scenes that they do not know of.
class Trial {
public:
    Trial(const MeasuredSkies& skies, const Predictor& predictor) : skies_(skies), predictor_(predictor) {}

    void run(std::size_t scene) {
        Predictor::Here here = predictor_.at(skies_.scenes[scene].situation);
        distances_.push_back(here.distance());
        for (const MeasuredSetting& setting : predictor_.skies().settings) {
            add(sky_, here, setting.sky_p95, scene);
            for (const MeasuredError* error : detail::errors_of_geometry(setting, 1000 * detail::farthest_geometry_km))
                if (error != nullptr) add(geometry_, here, *error, scene);
            add(light_, here, setting.light, scene);
        }
        for (const MeasuredError& error : predictor_.skies().bare) add(bare_, here, error, scene);
        for (const double km : geometry_km) choose(scene, here, km);
    }

    Coverage result() {
        Coverage found;
        found.sky = summary_of(sky_);
        found.geometry = summary_of(geometry_);
        found.light = summary_of(light_);
        found.bare = summary_of(bare_);
        sky_.insert(sky_.end(), geometry_.begin(), geometry_.end());
        found.radiance = summary_of(sky_);
        found.choices = choices_;
        if (choices_ > 0) found.choices_kept = static_cast<double>(kept_) / static_cast<double>(choices_);
        std::ranges::sort(distances_);
        found.distance = quantile(distances_, 0.5);
        return found;
    }

private:
    static void add(std::vector<Foretold>& list, Predictor::Here& here, const MeasuredError& error, std::size_t scene) {
        const std::optional<double> truth = error.in(scene);
        const auto predicted = truth ? here.predict(error) : std::nullopt;
        if (predicted) list.push_back({predicted->bound / *truth, std::abs(std::log(predicted->likely / *truth))});
    }

    /// Geometry without the air before it.
    struct BareGeometry {
        detail::PredictedError foretold;
        double measured = 0;
    };
    /// At one of detail::bare_distances_km; none where it was not measured in the scene, or is not foretold.
    [[nodiscard]] std::optional<BareGeometry> bare_geometry(std::size_t scene, Predictor::Here& here, double km) const {
        const auto at = std::ranges::find(detail::bare_distances_km, km);
        const detail::MeasuredScene& place = skies_.scenes[scene];
        const std::optional<double> densest = detail::densest_extinction_per_m(place.situation, place.altitude_m);
        if (at == detail::bare_distances_km.end() || !densest) return {};
        const auto foretold = here.bare(1000 * km, *densest);
        const auto measured = skies_.bare[static_cast<std::size_t>(at - detail::bare_distances_km.begin())].in(scene);
        if (!foretold || !measured) return {};
        const double share = detail::bare_share(detail::extinction_per_m(*densest, place.situation), km);
        return BareGeometry{*foretold, share * *measured};
    }

    struct Choice {
        PlanCandidate candidate;
        double measured = 0;  ///< Its error in the scene.
    };
    /// The settings that were measured in the scene, with their costs there.
    [[nodiscard]] std::vector<Choice> choices_with(const PlanRequirements& needs, detail::AirBefore air, std::size_t scene,
                                                   Predictor::Here& here, const BareGeometry& bare) const {
        const PlanRequirements judged = detail::judged_by(needs, air);
        std::vector<Choice> choices;
        for (const MeasuredSetting& setting : predictor_.skies().settings) {
            const MeasuredCost& cost = setting.by_air[skies_.scenes[scene].air];
            const std::optional<double> measured = detail::measured_worst(judged, setting, scene);
            const auto error = measured ? detail::worse(judged, setting, here, {}) : std::nullopt;
            if (!error || cost.air_mib == 0) continue;
            const PlanCost costs = detail::cost_of(needs, cost, air).cost;
            choices.push_back({{setting.setting, *error, costs, false, {}}, *measured});
            if (air != detail::AirBefore::left_out) continue;
            choices.back().candidate.error = detail::worse_of(*error, bare.foretold);
            choices.back().measured = std::max(*measured, bare.measured);
        }
        return choices;
    }

    /// As plan() does; with geometry as far as `km`, before which it leaves the air out where that was measured and is foretold
    /// to do; 0: without.
    void choose(std::size_t scene, Predictor::Here& here, double km) {
        const std::vector<MeasuredSetting>& settings = predictor_.skies().settings;
        PlanRequirements needs;
        needs.geometry = km > 0;
        if (needs.geometry) needs.geometry_range_m = 1000 * km;
        needs.light = std::ranges::any_of(settings, [&](const auto& one) { return one.light.in(scene).has_value(); });
        const auto bare = bare_geometry(scene, here, km);
        const auto foretold = bare ? std::optional(bare->foretold) : std::nullopt;
        for (const double tolerance : tolerances) {
            needs.tolerance = tolerance;
            const auto choices =
                choices_with(needs, detail::choose_air(needs, foretold), scene, here, bare.value_or(BareGeometry{}));
            if (!choices.empty()) count(needs, choices);
        }
    }
    void count(const PlanRequirements& needs, const std::vector<Choice>& choices) {
        std::vector<PlanCandidate> candidates;
        for (const Choice& one : choices) {
            candidates.push_back(one.candidate);
            candidates.back().tolerable = detail::tolerates(needs, one.candidate);
        }
        const std::size_t best = detail::best_of(needs, candidates);
        if (!candidates[best].tolerable) return;
        ++choices_;
        if (choices[best].measured <= *needs.tolerance) ++kept_;
    }

    const MeasuredSkies& skies_;
    const Predictor& predictor_;
    std::vector<Foretold> sky_, geometry_, light_, bare_;
    std::vector<double> distances_;
    std::size_t choices_ = 0, kept_ = 0;
};

/// Of all settings that were measured in an air, as the others foretell it.
std::vector<ForetoldCost> costs_in(const MeasuredSkies& skies, std::size_t air, const Predictor& predictor,
                                   const detail::Situation& place) {
    const PlanRequirements needs;
    std::vector<ForetoldCost> result;
    for (const MeasuredSetting& setting : predictor.skies().settings) {
        const MeasuredCost& known = setting.by_air[air];
        if (known.air_mib == 0) continue;
        const std::optional<MeasuredCost> foretold = predictor.cost(setting, place, known.work);
        if (!foretold) continue;
        const PlanCost then = detail::cost_of(needs, *foretold).cost, now = detail::cost_of(needs, known).cost;
        const std::string where = skies.airs[air], what = setting.setting.id();
        result.push_back({where, what, "frame", then.frame_ms, now.frame_ms});
        result.push_back({where, what, "rebuild", then.rebuild_ms, now.rebuild_ms});
        result.push_back({where, what, "composite", foretold->composite_ms, known.composite_ms});
    }
    return result;
}

}  // namespace

std::vector<std::size_t> drawn_third(const MeasuredSkies& skies, std::uint32_t seed) {
    std::vector<std::size_t> order = all_but(skies.scenes.size(), {});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return hash_of(skies.scenes[i].id, seed); });
    order.resize(order.size() / 3);
    std::ranges::sort(order);
    return order;
}

Coverage coverage(const MeasuredSkies& skies, const std::vector<std::size_t>& held_out) {
    MeasuredSkies fitted = skies;
    const std::vector<std::size_t> seen = all_but(skies.scenes.size(), held_out);
    fit(fitted, seen);
    const Predictor predictor(fitted, seen);
    Trial trial(skies, predictor);
    for (const std::size_t scene : held_out) trial.run(scene);
    return trial.result();
}

std::vector<AirLeftOut> without_each_air(const MeasuredSkies& skies) {
    std::vector<AirLeftOut> result;
    for (std::size_t air = 0; air < skies.airs.size(); ++air) {
        std::vector<std::size_t> held_out;
        for (std::size_t i = 0; i < skies.scenes.size(); ++i)
            if (skies.scenes[i].air == air) held_out.push_back(i);
        const std::vector<std::size_t> seen = all_but(skies.scenes.size(), held_out);
        if (held_out.empty() || seen.empty()) continue;
        MeasuredSkies fitted = skies;
        fit(fitted, seen);
        const Predictor predictor(fitted, seen);
        Trial trial(skies, predictor);
        for (const std::size_t scene : held_out) trial.run(scene);
        result.push_back(
            {skies.airs[air], trial.result(), costs_in(skies, air, predictor, skies.scenes[held_out.front()].situation)});
    }
    return result;
}

}  // namespace aureole::app
