// How fast a device is, for the planner.
#pragma once

#include "app/backend.h"

#include <aureole/plan.h>

namespace aureole::app {

/// Measures what `calibrated` wants for about so many seconds, at least three rounds. Throws Error(unsupported) if the device
/// has no clock.
[[nodiscard]] DeviceSpeed measure_speed(Backend& backend, double seconds);

}  // namespace aureole::app
