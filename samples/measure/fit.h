// From measurements to what the planner knows: gathering them, and fitting how they vary from scene to scene.
#pragma once

#include "plan/measured.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// The scenes of measurements (docs/measure.md) in red, green and blue, or those in wavelengths, with the settings that were
/// measured in them; not fitted. Of a setting and scene that occur twice the later counts. Throws Error(invalid_argument)
/// naming what a file lacks, or where none was measured with costs: what one air costs is known by its work from others.
[[nodiscard]] detail::MeasuredSkies gather(std::span<const nlohmann::json> measurements, bool wavelengths);

/// Finds `lengths`, `spread` and `margin` from these scenes alone (empty: all): lengths by the pseudo-likelihood of each scene
/// given the others (Sundararajan & Keerthi 2001), the margin so that 97 of 100 scenes left out lie below their bound.
void fit(detail::MeasuredSkies& skies, const std::vector<std::size_t>& scenes = {});

/// Indices of a third of the scenes, drawn by a hash of seed and id: the same on every machine.
[[nodiscard]] std::vector<std::size_t> drawn_third(const detail::MeasuredSkies& skies, std::uint32_t seed);

/// How predictions hold on scenes that the fit has not seen.
struct Coverage {
    struct Of {
        std::size_t predictions = 0;
        double below_bound = 0;    ///< Share of measured p95 that lies at or below the bound.
        double median_excess = 0;  ///< Median of bound / measured p95.
        double median_off = 0;     ///< Median of |ln(likely / measured)|.
    };
    Of all, sky, geometry;
    /// Choices of the cheapest setting whose bound is within a tolerance (0.5 to 20 %), of the sky, in each of those scenes;
    /// and the share of them that keep it. Less than below_bound: of many settings the one is taken whose bound is lowest.
    std::size_t choices = 0;
    double choices_kept = 0;
};
/// Fits a copy to all but `held_out`, and predicts those: p95 of the sky and of geometry, every setting.
[[nodiscard]] Coverage coverage(const detail::MeasuredSkies& skies, const std::vector<std::size_t>& held_out);

/// C++ that initializes a MeasuredSkies: what the library is compiled with (plan/measured_*.inc).
[[nodiscard]] std::string print_initializer(const detail::MeasuredSkies& skies);

}  // namespace aureole::app
