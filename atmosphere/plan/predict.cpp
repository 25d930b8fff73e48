#include "plan/predict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace aureole::detail {
namespace {

/// A cost, and the work that it grows with.
struct CostOfWork {
    double MeasuredCost::*cost;
    double TableWork::*work = nullptr;

    [[nodiscard]] double work_in(const TableWork& all) const { return work != nullptr ? all.*work : 1; }
};
constexpr std::array<CostOfWork, 13> costs{{{&MeasuredCost::composite_ms},
                                            {&MeasuredCost::composite_geometry_ms},
                                            {&MeasuredCost::view_ms, &TableWork::view},
                                            {&MeasuredCost::aerial_perspective_ms, &TableWork::view},
                                            {&MeasuredCost::light_ms},
                                            {&MeasuredCost::rebuild_ms, &TableWork::rebuild},
                                            {&MeasuredCost::air_mib, &TableWork::air_memory},
                                            {&MeasuredCost::view_mib, &TableWork::view_memory},
                                            {&MeasuredCost::aerial_perspective_mib, &TableWork::aerial_perspective_memory},
                                            {&MeasuredCost::composite_sun_ms},
                                            {&MeasuredCost::shadows_ms},
                                            {&MeasuredCost::composite_shadows_ms},
                                            {&MeasuredCost::shadows_mib, &TableWork::view_memory}}};
constexpr double least_cost = 1e-12;  // by work, of what takes no time at all

/// The air alone.
Situation at_rest(Situation situation) {
    std::fill_n(situation.begin(), 3, 0.0);
    return situation;
}

}  // namespace

Predictor::Predictor(const MeasuredSkies& skies, std::vector<std::size_t> scenes) : skies_(skies), scenes_(std::move(scenes)) {
    if (scenes_.empty()) {
        scenes_.resize(skies.scenes.size());
        std::iota(scenes_.begin(), scenes_.end(), std::size_t{0});
    }
    airs_.resize(skies.airs.size());
    for (const MeasuredScene& scene : skies.scenes) airs_[scene.air] = at_rest(scene.situation);
}

Predictor::Known& Predictor::known(std::vector<std::size_t> points, bool airs, const Situation& place) {
    const auto key = std::pair(airs, points);
    auto found = known_.find(key);
    if (found == known_.end()) {
        std::vector<Situation> places;
        for (const std::size_t i : points) places.push_back(airs ? airs_[i] : skies_.scenes[i].situation);
        found = known_.emplace(key, Known{std::move(points), Kriging(std::move(places), skies_.lengths), {}, {}}).first;
    }
    Known& known = found->second;
    if (!known.weights || known.place != place) known.weights = known.kriging.at(place);
    known.place = place;
    return known;
}

std::optional<PredictedError> Predictor::predict(const MeasuredError& error, const Situation& place) {
    std::vector<std::size_t> points;
    for (const std::size_t i : scenes_)
        if (error.by_scene[i] != MeasuredError::unknown) points.push_back(i);
    if (points.size() < fewest_scenes) return {};
    const Known& from = known(std::move(points), false, place);
    double logarithm = 0;
    for (std::size_t k = 0; k < from.points.size(); ++k)
        logarithm += from.weights->of_points[k] * error.by_scene[from.points[k]] / 1000;
    return PredictedError{std::exp(logarithm),
                          std::exp(logarithm + skies_.margin * error.spread * std::sqrt(from.weights->variance))};
}

std::optional<MeasuredCost> Predictor::cost(const MeasuredSetting& setting, const Situation& place, const TableWork& work) {
    std::vector<std::size_t> points;
    for (std::size_t air = 0; air < setting.by_air.size(); ++air)
        if (setting.by_air[air].air_mib > 0) points.push_back(air);
    if (points.empty()) return {};
    const Known& from = known(std::move(points), true, at_rest(place));
    MeasuredCost result;
    result.work = work;
    for (const CostOfWork& one : costs) {
        double logarithm = 0;
        for (std::size_t k = 0; k < from.points.size(); ++k) {
            const MeasuredCost& known_here = setting.by_air[from.points[k]];
            logarithm +=
                from.weights->of_points[k] * std::log(known_here.*one.cost / one.work_in(known_here.work) + least_cost);
        }
        result.*one.cost = std::max(std::exp(logarithm) - least_cost, 0.0) * one.work_in(work);
    }
    return result;
}

Predictor::Nearest Predictor::nearest(const Situation& place, std::size_t most) {
    const Known& all = known(scenes_, false, place);
    if (loneliest_ == 0) loneliest_ = std::ranges::max(all.kriging.left_out_variances());
    Nearest result{scenes_, std::sqrt(all.weights->variance / loneliest_)};
    const auto near = [&](std::size_t i) { return covariance(skies_.scenes[i].situation, place, skies_.lengths); };
    std::ranges::sort(result.scenes, std::ranges::greater(), near);
    result.scenes.resize(std::min(result.scenes.size(), most));
    return result;
}

}  // namespace aureole::detail
