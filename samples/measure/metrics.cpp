#include "measure/metrics.h"

#include "app/quantile.h"
#include "common/luminance.h"

#include <aureole/spectrum.h>

#include <algorithm>
#include <cmath>

namespace aureole::app {
namespace {

Channels channels(const Rgb& v) { return {v.r, v.g, v.b}; }
bool is_known(const TrueValue& truth) {
    return row_error(channels(truth.value), channels(truth.value), channels(truth.error)).has_value();
}

glm::dvec3 shown_lab(const Rgb& radiance, double exposure) {
    return spectrum::lab_from_xyz(spectrum::xyz_from_rec709(glm::clamp(radiance * exposure, Rgb(0), Rgb(1))),
                                  spectrum::white_d65());
}

}  // namespace

ErrorSummary summarize(std::vector<double> errors) {
    if (errors.empty()) return {};
    std::ranges::sort(errors);
    return {errors.size(), quantile(errors, 0.5), quantile(errors, 0.95), errors.back()};
}

std::optional<double> relative_error(const Rgb& seen, const TrueValue& truth) {
    if (!is_known(truth)) return {};
    return row_error(channels(seen), channels(truth.value), channels(truth.error));
}

std::optional<double> part_of_error(const Rgb& a, const Rgb& b, const TrueValue& truth) {
    if (!is_known(truth)) return {};
    const Rgb apart = glm::abs(a - b), light = glm::abs(truth.value);
    return (apart.r + apart.g + apart.b) / (light.r + light.g + light.b);
}

std::optional<double> luminance_error(const Rgb& seen, const TrueValue& truth) {
    if (!is_known(truth)) return {};
    return std::abs(luminance(seen) / luminance(truth.value) - 1);
}

std::optional<double> luminance_part(const Rgb& a, const Rgb& b, const TrueValue& truth) {
    if (!is_known(truth)) return {};
    return std::abs(luminance(a) - luminance(b)) / luminance(truth.value);
}

std::optional<double> luminance_rmse(std::span<const Rgb> seen, std::span<const TrueValue> truth) {
    double squares = 0, light = 0, rows = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!is_known(truth[i])) continue;
        const double apart = luminance(seen[i]) - luminance(truth[i].value);
        squares += apart * apart;
        light += luminance(truth[i].value);
        rows += 1;
    }
    if (!(light > 0)) return {};
    return std::sqrt(squares / rows) / (light / rows);
}

double fixed_exposure(std::span<const TrueValue> truth) {
    constexpr double share = 0.9, shown = 0.8;
    std::vector<double> light;
    for (const TrueValue& value : truth) light.push_back(luminance(value.value));
    std::ranges::sort(light);
    const double bright = quantile(light, share);
    return bright > 0 ? shown / bright : 1;
}

double shown_difference(const Rgb& a, const Rgb& b, double exposure) {
    return spectrum::delta_e_2000(shown_lab(a, exposure), shown_lab(b, exposure));
}

double banding(std::span<const Rgb> seen, std::span<const Rgb> fine, double exposure) {
    double worst = 0;
    for (std::size_t i = 1; i < seen.size(); ++i) {
        const double step = shown_difference(seen[i - 1], seen[i], exposure);
        worst = std::max(worst, std::abs(step - shown_difference(fine[i - 1], fine[i], exposure)));
    }
    return worst;
}

}  // namespace aureole::app
