// Measurements by class of scenes: what tables and charts show.
#pragma once

#include "report/measurements.h"

namespace aureole::app::report {

/// How many scenes become one, in words for the reader of a table.
inline constexpr std::string_view aggregation_note =
    "Over the scenes of a class: of a median, the median of the scenes' medians; of every other error, the worst scene's. "
    "Costs are the median over the scenes, each with that of its air. What a simplification adds is found scene by scene: of "
    "the "
    "medians the median, of the 95th percentiles the greatest.";

/// What is saved of a cost, and which share of it; none of nothing.
struct Saving {
    double amount = 0;
    std::optional<double> share;
    [[nodiscard]] bool operator==(const Saving&) const = default;
};

/// One setting over scenes: errors as aggregation_note says. What no scene has is missing.
struct Summary {
    std::size_t setting = 0;
    std::size_t scenes = 0;
    std::map<std::string, Spread> regions;
    std::map<std::string, std::map<std::string, Spread>> split;  ///< As MeasuredResult's.
    std::map<std::string, double> errors;                        ///< By keys of scene_figures.
    std::map<std::string, double> costs;                         ///< By keys of cost_figures.
    std::optional<Saving> without_air;  ///< Of a frame with geometry's ms, where the air before it is left out.
};

/// What leaving something out costs and saves: a setting minus its baseline, over the scenes of a class that both have.
struct Simplification {
    std::size_t setting = 0, baseline = 0, scenes = 0;
    /// Of region `all`, fractions; negative: the error became smaller. Of the differences in each scene the median, and of
    /// the 95th percentiles' the greatest.
    std::optional<double> added_median, added_p95;
    std::optional<double> added_geometry_median, added_geometry_p95;  ///< The same of region `aerial`.
    /// By keys of cost_figures: those that both have.
    std::map<std::string, Saving> saved;
};

struct ClassSummary {
    std::string name;
    std::size_t scenes = 0;
    std::vector<Summary> settings;                  ///< Those with a result, in the file's order.
    std::map<double, std::vector<Summary>> by_sun;  ///< The same by elevation of the sun in degrees.
    std::vector<Simplification> simplifications;
    /// Errors of geometry without the air before it, by its distance in km: of medians the median, of the rest the worst scene.
    std::map<double, Spread> bare;
};

/// In the order in which the scenes name the classes.
[[nodiscard]] std::vector<ClassSummary> summarize(const Measurements& all);

/// Over these results of one setting.
[[nodiscard]] Summary summarize(const Measurements& all, std::size_t setting,
                                const std::vector<const MeasuredResult*>& results);

}  // namespace aureole::app::report
