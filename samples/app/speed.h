// How fast a device is, for the planner; and how fast a plan is on it.
#pragma once

#include "app/backend.h"

#include <aureole/plan.h>

namespace aureole::app {

/// Measures what `calibrated` wants for about so many seconds, at least three rounds. Throws Error(unsupported) if the device
/// has no clock.
[[nodiscard]] DeviceSpeed measure_speed(Backend& backend, double seconds);

/// What a plan that was made for these requirements takes on this device: medians of so many rounds, for all views and suns as
/// PlanCost counts them; of the memory nothing. Throws as above.
[[nodiscard]] PlanCost measure_plan(Backend& backend, const PlanRequirements& requirements, const Plan& plan,
                                    std::uint32_t rounds);

}  // namespace aureole::app
