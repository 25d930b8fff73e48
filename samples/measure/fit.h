// From measurements to what the planner knows: gathering them, and fitting how they vary from scene to scene.
#pragma once

#include "plan/measured.h"

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// The scenes of measurements (docs/measure.md) in red, green and blue, or those in wavelengths, with the settings that were
/// measured in them; not fitted. Of a setting and scene that occur twice the later counts. Errors of which the truth of less
/// than half of the directions is known are left out. Throws Error(invalid_argument)
/// naming what a file lacks, or where none was measured with costs: what one air costs is known by its work from others. That
/// work is what table_work says of `airs` today; of other airs what it said when they were measured.
[[nodiscard]] detail::MeasuredSkies gather(std::span<const nlohmann::json> measurements, bool wavelengths,
                                           const std::map<std::string, AtmosphereParameters>& airs = {});

/// Finds `lengths`, `spread` and `margin` from these scenes alone (empty: all): lengths by the pseudo-likelihood of each scene
/// given the others (Sundararajan & Keerthi 2001), the margin so that 97 of 100 scenes left
/// out lie below their bound; those of light likewise, by themselves.
void fit(detail::MeasuredSkies& skies, const std::vector<std::size_t>& scenes = {});

/// C++ that initializes a MeasuredSkies: what the library is compiled with (plan/measured_*.inc).
[[nodiscard]] std::string print_initializer(const detail::MeasuredSkies& skies);

}  // namespace aureole::app
