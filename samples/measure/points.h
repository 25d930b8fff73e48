// Where a scene is looked at: directions by region, the same for every model and for the truth.
#pragma once

#include "app/probe.h"

#include <aureole/parameters.h>

#include <array>
#include <string_view>
#include <vector>

namespace aureole::app {

enum class Region : std::uint8_t {
    zenith,     ///< Within 40 degrees of straight up.
    horizon,    ///< The band above the horizon; from above the air, the air beyond the limb of the planet.
    aureole,    ///< Within 12 degrees of the sun; of a sun below the horizon, above the place where it has set.
    antisolar,  ///< Above the horizon on the side away from the sun: where the planet's shadow rises.
    nadir,      ///< Down to the ground.
    aerial,     ///< Geometry between 1 and 100 km (aerial.h).
};
inline constexpr std::array<std::string_view, 6> region_names{"zenith", "horizon", "aureole", "antisolar", "nadir", "aerial"};

struct Point {
    Region region;
    ProbeRow row;
};
/// All but those of Region::aerial. Angles are whole multiples of 1e-4 degrees, so that they are the same numbers everywhere.
/// What a scene does not have is left out: from above the air there is no zenith.
[[nodiscard]] std::vector<Point> points_of(const Planet& planet, double sun_zenith_deg, double altitude_km);

/// Two rows of pixels across the sky above the horizon, 0.1 degrees apart, for steps that the eye would see: 96 upwards from
/// 0.1 degrees at 60 degrees from the sun's azimuth, and 64 sideways from there at 15 degrees. Empty from above the air.
inline constexpr std::size_t scan_up = 96, scan_across = 64;
[[nodiscard]] std::vector<ProbeRow> scan_of(const Planet& planet, double sun_zenith_deg, double altitude_km);

}  // namespace aureole::app
