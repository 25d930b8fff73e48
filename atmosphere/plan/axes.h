// Scales on which the sun's elevation and the camera's altitude are told apart.
#pragma once

#include <aureole/parameters.h>

#include <cmath>

namespace aureole::detail {

/// Fine at the horizon, coarse at noon.
[[nodiscard]] inline double sun_axis(double elevation_deg) { return std::asinh(elevation_deg / 3); }
[[nodiscard]] inline double elevation_of(double on_axis) { return 3 * std::sinh(on_axis); }

/// Fine near the ground, by ratios above a thirtieth of the air's thickness.
[[nodiscard]] inline double altitude_unit(const Planet& planet) { return (planet.top_radius_m - planet.bottom_radius_m) / 30; }
[[nodiscard]] inline double altitude_axis(double altitude_m, const Planet& planet) {
    return std::asinh(altitude_m / altitude_unit(planet));
}
[[nodiscard]] inline double altitude_of(double on_axis, const Planet& planet) {
    return altitude_unit(planet) * std::sinh(on_axis);
}

}  // namespace aureole::detail
