// What each model costs in each of its qualities, all of them measured in one run.
#pragma once

#include "app/backend.h"
#include "scene/scene.h"

#include <aureole/atmosphere.h>

#include <aureole/rhi/shader.h>

#include <functional>
#include <string>
#include <vector>

namespace aureole::app {

struct BenchOptions {
    std::vector<SceneModel> models;  ///< What is measured, in this order.
    std::string preset = "earth";    ///< The air: one of presets::names().
    std::uint32_t width = 1280, height = 720;
    std::uint32_t frames = 20;  ///< Measured rounds.
    std::uint32_t warm_up = 2;  ///< Rounds before them that are thrown away.
    bool raster = false;
    bool linear = false;  ///< Composite into half floats, without exposure, tone map, sRGB curve and dither.
    bool counts = true;   ///< Also count the passes' work, with a run on the CPU backend.
};

/// Milliseconds: the middle and what 80 % of the samples lie between.
struct Spread {
    double median = 0, p10 = 0, p90 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> samples);

struct BenchPass {
    std::string name;  ///< As in PassReport; "composite" without and "composite_geometry" with a host's colour and depth.
    Spread milliseconds;
    std::uint64_t invocations = 0;
    rhi::CpuCounts counts;  ///< Of the same pass on the CPU backend, counted as it runs.
};

struct BenchResult {
    SceneModel model;
    std::vector<BenchPass> passes;                ///< Of the air, of the view, "composite", "composite_geometry".
    std::size_t air_passes = 0, view_passes = 0;  ///< How many of each, the view's without composites.
    Spread per_frame;                             ///< All passes of the view together.
    Spread rebuild;                               ///< All passes of the air and per_frame.
    std::uint64_t table_bytes = 0;                ///< Device memory of all tables of one planet and one view.

    [[nodiscard]] const BenchPass& pass(std::string_view name) const;
    /// "hillaire default", "aureole default 4"
    [[nodiscard]] std::string label() const {
        return model.name + " " + model.quality + (model.in_rgb() ? "" : " " + model.spectral);
    }
};

/// For each of the models. Rounds go through all of them in turn, so that what else the machine does hits all alike. In every
/// round sun and ground albedo have moved, so that every pass runs. Throws Error(unsupported) if the device has no clock.
[[nodiscard]] std::vector<BenchResult> bench(Backend& backend, const BenchOptions& options,
                                             const std::function<void()>& after_round);

}  // namespace aureole::app
