#include "plan/predict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
constexpr std::array<CostOfWork, 14> costs{{{&MeasuredCost::composite_ms, &TableWork::composite},
                                            {&MeasuredCost::composite_geometry_ms, &TableWork::composite},
                                            {&MeasuredCost::view_ms, &TableWork::view},
                                            {&MeasuredCost::aerial_perspective_ms, &TableWork::view},
                                            {&MeasuredCost::light_ms, &TableWork::light},
                                            {&MeasuredCost::rebuild_ms, &TableWork::rebuild},
                                            {&MeasuredCost::air_mib, &TableWork::air_memory},
                                            {&MeasuredCost::view_mib, &TableWork::view_memory},
                                            {&MeasuredCost::aerial_perspective_mib, &TableWork::aerial_perspective_memory},
                                            {&MeasuredCost::composite_sun_ms, &TableWork::composite},
                                            {&MeasuredCost::shadows_ms},
                                            {&MeasuredCost::composite_shadows_ms},
                                            {&MeasuredCost::shadows_mib, &TableWork::view_memory},
                                            {&MeasuredCost::composite_bare_ms, &TableWork::composite}}};
constexpr double least_cost = 1e-12;  // by work, of what takes no time at all

/// The air alone.
Situation at_rest(Situation situation) {
    std::fill_n(situation.begin(), axis_of_space + 1, 0.0);
    return situation;
}

/// In units of their axes.
double distance_between(const Situation& a, const Situation& b) {
    double square = 0;
    for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(square);
}

using AtBareDistances = std::array<PredictedError, bare_distances_km.size()>;

/// Geometry up to a distance is also what is nearer.
void grow_with_distance(AtBareDistances& at) {
    for (std::size_t i = 1; i < at.size(); ++i)
        at[i] = {std::max(at[i].likely, at[i - 1].likely), std::max(at[i].bound, at[i - 1].bound)};
}

/// At `km`, no farther than that of `at[farther]` and farther than the one before: evenly over the logarithms of both; nearer
/// than all in proportion.
double likely_between(const AtBareDistances& at, std::size_t farther, double km) {
    const double far = at[farther].likely, far_km = bare_distances_km[farther];
    if (farther == 0) return far * km / far_km;
    const double near = at[farther - 1].likely, near_km = bare_distances_km[farther - 1];
    if (!(near > 0)) return far;
    return std::min(far, near * std::pow(far / near, std::log(km / near_km) / std::log(far_km / near_km)));
}

}  // namespace

Predictor::Predictor(const MeasuredSkies& skies, std::vector<std::size_t> scenes) : skies_(skies), scenes_(std::move(scenes)) {
    if (scenes_.empty()) {
        scenes_.resize(skies.scenes.size());
        std::iota(scenes_.begin(), scenes_.end(), std::size_t{0});
    }
    airs_.resize(skies.airs.size());
    for (const std::size_t i : scenes_) airs_[skies.scenes[i].air] = at_rest(skies.scenes[i].situation);
    if (scenes_.empty()) return;
    Index index;
    all_ = family_of(index, scenes_, false);
    std::vector<double> variances = families_[all_].kriging.left_out_variances();
    std::ranges::sort(variances);
    lonely_ = variances[(variances.size() - 1) * 9 / 10];
    for (const MeasuredSetting& setting : skies.settings) {
        for (const auto error : measured_errors) learn(index, setting.*error);
        knows_light_ |= errors_.contains(&setting.light);
        learn(index, setting);
    }
    for (const MeasuredError& error : skies.bare) learn(index, error);
}

std::size_t Predictor::family_of(Index& index, std::vector<std::size_t> points, bool airs) {
    const auto [found, is_new] = index.try_emplace({airs, points}, families_.size());
    if (!is_new) return found->second;
    std::vector<Situation> places;
    places.reserve(points.size());
    for (const std::size_t i : points) places.push_back(airs ? *airs_[i] : skies_.scenes[i].situation);
    families_.push_back({std::move(points), Kriging(std::move(places), skies_.lengths)});
    return found->second;
}

void Predictor::learn(Index& index, const MeasuredError& error) {
    std::vector<std::size_t> points;
    Known known;
    for (const std::size_t i : scenes_) {
        if (!error.is_known(i)) continue;
        points.push_back(i);
        known.logarithms.push_back(error.by_scene[i] / 1000.0);
    }
    if (points.size() < fewest_scenes) return;
    known.family = family_of(index, std::move(points), false);
    errors_.emplace(&error, std::move(known));
}

void Predictor::learn(Index& index, const MeasuredSetting& setting) {
    std::vector<std::size_t> points;
    for (std::size_t air = 0; air < setting.by_air.size(); ++air)
        if (airs_[air] && setting.by_air[air].air_mib > 0) points.push_back(air);
    if (!points.empty()) costs_.emplace(&setting, family_of(index, std::move(points), true));
}

const Kriging::Weights& Predictor::Here::weights(std::size_t family) {
    if (!weights_[family]) weights_[family] = from_.families_[family].kriging.at(place_);
    return *weights_[family];
}

std::optional<PredictedError> Predictor::Here::predict(const MeasuredError& error) {
    const auto known = from_.errors_.find(&error);
    if (known == from_.errors_.end()) return {};
    const Kriging::Weights& weighed = weights(known->second.family);
    const double logarithm = dot(weighed.of_points, known->second.logarithms);
    return PredictedError{std::exp(logarithm),
                          std::exp(logarithm + from_.skies_.margin * error.spread * std::sqrt(weighed.variance))};
}

std::optional<PredictedError> Predictor::Here::bare(double range_m, double densest) {
    constexpr double rounding = 1e-9;  // a known distance in metres is that distance
    const double km = (1 - rounding) * range_m / 1000;
    if (above_air() || km > bare_distances_km.back()) return {};
    AtBareDistances at;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto known = predict(from_.skies_.bare[i]);
        if (!known) return {};
        const double share = bare_share(extinction_per_m(densest, place_), bare_distances_km[i]);
        at[i] = {share * known->likely, share * known->bound};
    }
    grow_with_distance(at);
    const auto farther = static_cast<std::size_t>(std::ranges::lower_bound(bare_distances_km, km) - bare_distances_km.begin());
    return PredictedError{likely_between(at, farther, km), at[farther].bound};
}

double Predictor::Here::distance() {
    const Situation air = at_rest(place_);
    double apart = std::numeric_limits<double>::infinity();
    for (const std::optional<Situation>& known : from_.airs_)
        if (known) apart = std::min(apart, distance_between(air, *known));
    return std::max(std::sqrt(weights(from_.all_).variance / from_.lonely_), apart);
}

std::vector<std::size_t> Predictor::Here::nearest(std::size_t most) const {
    std::vector<std::pair<double, std::size_t>> unlike;
    for (const std::size_t i : from_.scenes_)
        unlike.emplace_back(-covariance(from_.skies_.scenes[i].situation, place_, from_.skies_.lengths), i);
    std::ranges::sort(unlike);
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < std::min(unlike.size(), most); ++k) result.push_back(unlike[k].second);
    return result;
}

std::optional<MeasuredCost> Predictor::cost(const MeasuredSetting& setting, const Situation& place,
                                            const TableWork& work) const {
    const auto family = costs_.find(&setting);
    if (family == costs_.end()) return {};
    const Family& from = families_[family->second];
    const Kriging::Weights weights = from.kriging.at(at_rest(place));
    MeasuredCost result;
    result.work = work;
    for (const CostOfWork& one : costs) {
        double logarithm = 0;
        bool any = false;  // of what older tables do not have, none
        for (std::size_t k = 0; k < from.points.size(); ++k) {
            const MeasuredCost& known_here = setting.by_air[from.points[k]];
            any |= known_here.*one.cost > 0;
            logarithm += weights.of_points[k] * std::log(known_here.*one.cost / one.work_in(known_here.work) + least_cost);
        }
        result.*one.cost = any ? std::max(std::exp(logarithm) - least_cost, 0.0) * one.work_in(work) : 0;
    }
    return result;
}

}  // namespace aureole::detail
