// How far apart two sets of radiances are: by region, as luminance, as colours on a display, and as steps in a gradient.
#pragma once

#include "app/row_error.h"

#include <aureole/parameters.h>

#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

/// Of errors, however they are measured.
struct ErrorSummary {
    std::size_t rows = 0;                   ///< 0: nothing to measure, and the rest is 0.
    double median = 0, p95 = 0, worst = 0;  ///< Quantiles as quantile.h has them.
};
[[nodiscard]] ErrorSummary summarize(std::vector<double> errors);

/// A true radiance (or irradiance) and its standard error.
struct TrueValue {
    Rgb value{0}, error{0};
};

/// row_error of colours: sum |dL| / sum L over the channels; none where the truth is too noisy, or black.
[[nodiscard]] std::optional<double> relative_error(const Rgb& seen, const TrueValue& truth);
/// sum |a - b| / sum |truth| over the channels: a part of such an error. None where that is none.
[[nodiscard]] std::optional<double> part_of_error(const Rgb& a, const Rgb& b, const TrueValue& truth);

/// Of the luminance (illuminance) alone, relative; none as above. A part of it: |a - b| over the true one.
[[nodiscard]] std::optional<double> luminance_error(const Rgb& seen, const TrueValue& truth);
[[nodiscard]] std::optional<double> luminance_part(const Rgb& a, const Rgb& b, const TrueValue& truth);

/// Root of the mean squared error of luminance over the mean true luminance; none for no light. Rows whose truth is too noisy
/// are left out.
[[nodiscard]] std::optional<double> luminance_rmse(std::span<const Rgb> seen, std::span<const TrueValue> truth);

/// Factor on radiance that shows a scene by its truth: what is brighter than 90 % of it gets luminance 0.8. 1 for no light.
[[nodiscard]] double fixed_exposure(std::span<const TrueValue> truth);
/// CIEDE2000 between two radiances as a display shows them with this exposure: each channel in [0, 1], no tone map.
[[nodiscard]] double shown_difference(const Rgb& a, const Rgb& b, double exposure);

/// Greatest of all by how much a step between neighbours of a scan differs from the same step of a finer one, in CIEDE2000:
/// |step(seen) - step(fine)|. What is smooth in the one shows no bands in the other. Both of the same length.
[[nodiscard]] double banding(std::span<const Rgb> seen, std::span<const Rgb> fine, double exposure);

}  // namespace aureole::app
