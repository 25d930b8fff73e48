// What each pass of models in airs costs: time on a device, and work as the CPU backend counts it, all measured in turn.
#pragma once

#include "app/backend.h"
#include "app/pass_times.h"

#include <aureole/atmosphere.h>

#include <aureole/rhi/shader.h>

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// A model in an air.
struct CostSubject {
    std::string label;  ///< For messages.
    AtmosphereParameters air;
    ModelPtr model;
};

/// What one round of a subject took: every pass, in milliseconds.
using CostRound = std::vector<PassTime>;
/// Of one subject: its passes' work by name.
using CostCounts = std::map<std::string, rhi::CpuCounts>;

struct PassCostOptions {
    std::uint32_t width = 1280, height = 720;  ///< Of the composite.
    std::uint32_t frames = 20;                 ///< Measured rounds.
    std::uint32_t warm_up = 2;                 ///< Rounds before them that are thrown away.
    bool raster = false;
    bool linear = false;   ///< Composite into half floats, without exposure, tone map, sRGB curve and dither.
    bool geometry = true;  ///< Also a composite with a host's colour and depth.
    /// Also a composite with two suns, one with geometry and no air before it, and one with geometry and shadows in the air (of
    /// models that have them): at a quarter of the pixels, which are taken to be as dear as all, and in every other round; and
    /// the pass "shadows". None of these are counted.
    bool features = false;
    bool counts = true;                                   ///< Also count the passes' work, with a run on the CPU backend.
    bool composites = true;                               ///< Count composites too.
    std::uint32_t counted_width = 0, counted_height = 0;  ///< Of the composite that is counted; 0: as measured.
    /// By subject, as many as there are, or none: rounds that an earlier run has measured; they count, and so many fewer are
    /// run.
    std::vector<std::vector<CostRound>> known{};
    /// Told of each round of a subject that is run and counts, as soon as it has been.
    std::function<void(std::size_t subject, const CostRound&)> after_measured{};
    /// The same of what has been counted: of the first subjects.
    std::vector<CostCounts> known_counts{};
    std::function<void(const CostCounts&)> after_counted{};
};

/// Milliseconds: the middle and what 80 % of the samples lie between.
struct Spread {
    double median = 0, p10 = 0, p90 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> samples);

struct PassCost {
    /// As in PassReport; "composite" without and "composite_geometry" with a host's colour and depth; "composite_two_suns",
    /// "composite_bare" of geometry without the air before it, "composite_shadows".
    std::string name;
    Spread milliseconds;
    std::uint64_t invocations = 0;
    rhi::CpuCounts counts;  ///< Of the same pass on the CPU backend, counted as it runs.
};

struct PassCosts {
    std::vector<PassCost> passes;                               ///< Of the air, of the view, then composites.
    std::size_t air_passes = 0, view_passes = 0;                ///< How many of each, the view's without composites.
    Spread per_frame;                                           ///< All passes of the view together.
    Spread frame;                                               ///< The same and the composite without geometry.
    Spread rebuild;                                             ///< All passes of the air and per_frame.
    std::uint64_t table_bytes = 0;                              ///< Device memory of all tables of one planet and one view.
    std::uint64_t air_bytes = 0, aerial_perspective_bytes = 0;  ///< Parts of it: of the planet; of the view's froxels.
    std::uint64_t shadow_bytes = 0;                             ///< What shadows add to it; 0 without `features`.

    [[nodiscard]] const PassCost& pass(std::string_view name) const;
};

/// For each of the subjects. Rounds go through all of them in turn, so that what else the machine does hits all alike. In every
/// round sun and ground albedo have moved, so that every pass runs. Throws Error(unsupported) if the device has no clock; an
/// error in one of the subjects names its label.
[[nodiscard]] std::vector<PassCosts> pass_costs(Backend& backend, std::span<const CostSubject> subjects,
                                                const PassCostOptions& options, const std::function<void()>& after_round);

}  // namespace aureole::app
