#include "measure/fit.h"

#include "app/quantile.h"
#include "plan/predict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace aureole::app {
namespace {

using detail::Kriging;
using detail::MeasuredError;
using detail::MeasuredSetting;
using detail::MeasuredSkies;
using detail::Situation;

constexpr double shortest = 0.05, longest = 500;  // of lengths
constexpr double covered = 0.97;                  // by the margin, of scenes that are left out
constexpr double least_spread = 1e-3;
constexpr double usual = 3;  // length where scenes do not tell
constexpr std::span radiance_errors = std::span(detail::measured_errors).first(5);
constexpr std::span light_errors = std::span(detail::measured_errors).last(1);
constexpr double kinds = 3;  // errors of all settings tell as much as so many that had nothing in common

std::vector<std::size_t> all_of(std::size_t count) {
    std::vector<std::size_t> result(count);
    std::iota(result.begin(), result.end(), std::size_t{0});
    return result;
}

/// Errors that are known in the same scenes.
struct Family {
    std::vector<std::size_t> scenes;
    std::vector<Situation> places;
    std::vector<MeasuredError*> errors;
    std::vector<std::vector<double>> values;  // by error
};

std::vector<MeasuredError*> of_settings(MeasuredSkies& skies, std::span<MeasuredError MeasuredSetting::*const> errors) {
    std::vector<MeasuredError*> result;
    for (MeasuredSetting& setting : skies.settings)
        for (const auto each : errors) result.push_back(&(setting.*each));
    return result;
}

std::vector<Family> families(const MeasuredSkies& skies, const std::vector<std::size_t>& scenes,
                             const std::vector<MeasuredError*>& errors) {
    std::map<std::vector<std::size_t>, Family> by_scenes;
    for (MeasuredError* const error : errors) {
        std::vector<std::size_t> known;
        for (const std::size_t i : scenes)
            if (error->is_known(i)) known.push_back(i);
        error->spread = 0;
        if (known.size() < detail::fewest_scenes) continue;
        Family& family = by_scenes[known];
        std::vector<double>& values = family.values.emplace_back();
        for (const std::size_t i : known) values.push_back(error->by_scene[i] / 1000.0);
        family.errors.push_back(error);
        family.scenes = std::move(known);
    }
    std::vector<Family> result;
    for (auto& [known, family] : by_scenes) {
        for (const std::size_t i : known) family.places.push_back(skies.scenes[i].situation);
        result.push_back(std::move(family));
    }
    return result;
}

double mean_square(const std::vector<double>& residuals, const std::vector<double>& variances) {
    double sum = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) sum += residuals[i] * residuals[i] / variances[i];
    return sum / static_cast<double>(residuals.size());
}

/// Minus the logarithm of the pseudo-likelihood, with the spread that is best for each error, and of what is likely for
/// lengths beforehand; less is better.
double misfit(const std::vector<Family>& all, const Situation& lengths) {
    double sum = 0, errors = 0;
    for (const Family& family : all) {
        errors += static_cast<double>(family.values.size());
        const Kriging kriging(family.places, lengths);
        const std::vector<double> variances = kriging.left_out_variances();
        double logarithms = 0;
        for (const double variance : variances) logarithms += std::log(variance);
        for (const std::vector<double>& values : family.values) {
            const double square = mean_square(kriging.left_out_residuals(values, variances), variances);
            sum += (static_cast<double>(values.size()) * std::log(std::max(square, 1e-12)) + logarithms) / 2;
        }
    }
    sum *= kinds / errors;
    for (const double length : lengths) sum += std::pow(std::log(length / usual), 2) / 2;
    return sum;
}

/// Axis by axis, with steps that shrink.
Situation best_lengths(const std::vector<Family>& all) {
    Situation lengths;
    lengths.fill(usual);
    double best = misfit(all, lengths);
    for (double factor = 3; factor > 1.15; factor = std::sqrt(factor))
        for (bool better = true; better;) {
            better = false;
            for (double& length : lengths)
                for (const double step : {factor, 1 / factor}) {
                    const double before = std::exchange(length, std::clamp(length * step, shortest, longest));
                    const double now = misfit(all, lengths);
                    const bool keep = now < best - 1e-4;
                    if (keep) best = now;
                    if (!keep) length = before;
                    better |= keep;
                }
        }
    return lengths;
}

/// The spread of each error. Returns all residuals by what is expected of them, sorted.
std::vector<double> find_spreads(std::vector<Family>& all, const Situation& lengths) {
    std::vector<double> standardized;
    for (Family& family : all) {
        const Kriging kriging(family.places, lengths);
        const std::vector<double> variances = kriging.left_out_variances();
        for (std::size_t k = 0; k < family.errors.size(); ++k) {
            const std::vector<double> residuals = kriging.left_out_residuals(family.values[k], variances);
            MeasuredError& error = *family.errors[k];
            error.spread = std::max(std::sqrt(mean_square(residuals, variances)), least_spread);
            for (std::size_t i = 0; i < residuals.size(); ++i)
                standardized.push_back(residuals[i] / (error.spread * std::sqrt(variances[i])));
        }
    }
    std::ranges::sort(standardized);
    return standardized;
}

/// As many lie below the same margin as of what it was found from. Of n scenes left out in turn as many lie below a quantile as
/// it says; for one more scene it takes the quantile of (n + 1) / n as much (split conformal prediction: Vovk et al. 2005),
/// which counts where scenes are few.
void fit_spreads(std::vector<Family> all, const MeasuredSkies& skies) {
    if (all.empty()) return;
    const std::size_t scenes =
        std::ranges::max_element(all, {}, [](const Family& f) { return f.scenes.size(); })->scenes.size();
    const double level = std::min(covered * (1 + 1 / static_cast<double>(scenes)), 1.0);
    const double wider = std::max(quantile(find_spreads(all, skies.lengths), level), 0.1) / skies.margin;
    for (Family& family : all)
        for (MeasuredError* error : family.errors) error->spread *= wider;
}

}  // namespace

void fit(MeasuredSkies& skies, const std::vector<std::size_t>& scenes) {
    const std::vector<std::size_t> known = scenes.empty() ? all_of(skies.scenes.size()) : scenes;
    skies.lengths.fill(usual);
    skies.margin = 2;
    // Errors of radiance say how airs and hours differ: those of light, one number a scene, pass through 0 here and there.
    std::vector<Family> radiance = families(skies, known, of_settings(skies, radiance_errors));
    if (!radiance.empty()) {
        skies.lengths = best_lengths(radiance);
        skies.margin = std::max(quantile(find_spreads(radiance, skies.lengths), covered), 0.1);
    }
    fit_spreads(families(skies, known, of_settings(skies, light_errors)), skies);  // mostly far off where they are small
    std::vector<MeasuredError*> bare;
    for (MeasuredError& error : skies.bare) bare.push_back(&error);
    fit_spreads(families(skies, known, bare), skies);
}

}  // namespace aureole::app
