// A suite measured: every setting in every air, resumable.
#pragma once

#include "measure/compare.h"

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

namespace aureole::app {

struct MeasureOptions {
    std::filesystem::path out;  ///< Folder of what is finished: a later run goes on from there.
    bool parts = true;          ///< Also split every error (Looks::exact, ::converged).
};

/// Runs settings x airs, each pair an item that is kept in `out`/items once it is done. `run` is what is measured, `exact` the
/// CPU in double. `after_item` follows each, also those that were done before. Returns what measurements.json holds of it
/// (docs/measure.md): scenes, settings, results. Throws Error; what is finished stays.
[[nodiscard]] nlohmann::json measure(const Suite& suite, const MeasureOptions& options, Backend& run, Backend& exact,
                                     const std::function<void(std::size_t done, std::size_t items)>& after_item);

}  // namespace aureole::app
