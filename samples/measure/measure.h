// A suite measured: every setting in every air, resumable.
#pragma once

#include "measure/compare.h"
#include "plan/measured.h"

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

namespace aureole::app {

struct MeasureOptions {
    std::filesystem::path out;      ///< Folder of what is finished: a later run goes on from there.
    bool parts = true;              ///< Also split every error (Looks::exact, ::converged).
    std::uint32_t cost_rounds = 5;  ///< Of measure_costs, each after the two that warm up. At least 1.
    /// Of the pictures whose costs are measured.
    std::uint32_t cost_width = detail::measured_width, cost_height = detail::measured_height;
    bool validation = false;  ///< `run` is under a validation layer: its costs are no others' costs.
};

/// Runs settings x airs, each pair an item that is kept in `out`/items once it is done. `run` is what is measured, `exact` the
/// CPU in double. `after_item` follows each, also those that were done before. Returns what measurements.json holds of it
/// (docs/measure.md): scenes, settings, results. Throws Error; what is finished stays.
[[nodiscard]] nlohmann::json measure(const Suite& suite, const MeasureOptions& options, Backend& run, Backend& exact,
                                     const std::function<void(std::size_t done, std::size_t items)>& after_item);

/// Pictures of the suite's scenes that want them: the truth, each setting, and how far it is from the truth (pictures.h), as
/// PNG in base64; kept as above.
[[nodiscard]] nlohmann::json measure_pictures(const Suite& suite, const MeasureOptions& options, Backend& run,
                                              const std::function<void(std::size_t done, std::size_t items)>& after_item);

/// What each setting costs in each air, on `run` (cost.h), all settings of an air in turn; kept as above. `reference` is left
/// out. Throws Error(unsupported) if the device has no clock.
[[nodiscard]] nlohmann::json measure_costs(const Suite& suite, const MeasureOptions& options, Backend& run,
                                           const std::function<void(std::size_t done, std::size_t rounds)>& after_round);

}  // namespace aureole::app
