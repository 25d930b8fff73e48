// How the planner's predictions hold in scenes, and in airs, that it has not been told of.
#pragma once

#include "plan/measured.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// Indices of a third of the scenes, drawn by a hash of seed and id: the same on every machine.
[[nodiscard]] std::vector<std::size_t> drawn_third(const detail::MeasuredSkies& skies, std::uint32_t seed);

struct Coverage {
    struct Of {
        std::size_t predictions = 0;
        double below_bound = 0;    ///< Share of measured errors that lie at or below the bound.
        double median_excess = 0;  ///< Median of bound / measured.
        double median_off = 0;     ///< Median of |ln(likely / measured)|.
    };
    Of sky, geometry, light;
    Of radiance;  ///< Sky and geometry.
    Of bare;      ///< Geometry without the air before it, at all distances.
    /// Choices that a plan makes (choose_air, best_of), among the settings measured there, within 0.5 to 20 %: of the sky in
    /// each of those scenes, and again with geometry up to 32 m, 320 m, 3.2 and 96 km, with the air before it or without, and
    /// light where it is known; and the share of them that keep the tolerance. Less than below_bound: of many settings the one
    /// is taken whose bound is lowest.
    std::size_t choices = 0;
    double choices_kept = 0;
    double distance = 0;  ///< Plan::distance of half of the scenes is less.
};
/// Fits a copy to all but `held_out`, and predicts those: p95 of the sky and of geometry, and light, by every setting.
[[nodiscard]] Coverage coverage(const detail::MeasuredSkies& skies, const std::vector<std::size_t>& held_out);

/// A plan's costs are to be within this share of what is measured.
inline constexpr double cost_tolerance = 0.3;

/// A cost in an air that the others foretell, and as it was measured there.
struct ForetoldCost {
    std::string air, setting;
    std::string_view what;  ///< "frame", "rebuild" or "composite": of a plan for sky and light.
    double foretold_ms = 0, measured_ms = 0;

    /// 0.3: foretold 30 % too much.
    [[nodiscard]] double off() const { return foretold_ms / measured_ms - 1; }
    /// What is off by no more than this counts as right: a hundredth of the cheapest sky's frame. A rebuild is measured as the
    /// difference of two medians, and of a model without tables it is their noise.
    static constexpr double least_ms = 0.15;
    [[nodiscard]] bool within(double share) const {
        return std::abs(foretold_ms - measured_ms) <= std::max(share * measured_ms, least_ms);
    }
};
struct AirLeftOut {
    std::string air;
    Coverage errors;
    std::vector<ForetoldCost> costs;  ///< Of the settings whose costs were measured there and elsewhere.
};
/// Of each air in turn: nothing is known of it but what it is made of. Airs without scenes, or alone, are passed over.
[[nodiscard]] std::vector<AirLeftOut> without_each_air(const detail::MeasuredSkies& skies);

}  // namespace aureole::app
