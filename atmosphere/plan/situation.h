// Where a sky is asked for, as the few numbers that errors and costs follow.
#pragma once

#include <aureole/parameters.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace aureole::detail {

/// Coordinates of a situation: each changes by about 1 where errors change by much.
inline constexpr std::array<std::string_view, 10> situation_axes{
    "sun",          // asinh(elevation / 3 degrees): fine at the horizon, coarse at noon
    "altitude",     // of the camera in scale heights of extinction, at most 8
    "space",        // ln(1 + 20 x height above the air / radius of the planet)
    "depth",        // ln(0.01 + vertical optical depth of scattering)
    "sharpness",    // ln(0.002 + that depth times the third moment of its phase functions)
    "absorption",   // ln(0.005 + vertical optical depth of absorption)
    "whiteness",    // 4 x the share of scattering in extinction
    "order ratio",  // 4 x order_ratio
    "ground",       // 2 x mean albedo
    "curvature",    // ln(scale height / radius of the planet)
};
using Situation = std::array<double, situation_axes.size()>;
inline constexpr std::size_t axis_of_sun = 0, axis_of_altitude = 1, axis_of_space = 2;  // the others are the air's
inline constexpr std::size_t axis_of_depth = 3, axis_of_absorption = 5;

/// Extinction per metre, the mean of the colours, where the air is densest and at a place: as if it were exponential.
[[nodiscard]] double densest_extinction_per_m(const AtmosphereParameters& parameters);
/// The same by the coordinates of a place whose altitude is known; none where they do not tell: on the ground, and from eight
/// scale heights on.
[[nodiscard]] std::optional<double> densest_extinction_per_m(const Situation& place, double altitude_m);
[[nodiscard]] inline double extinction_per_m(double densest, const Situation& place) {
    return densest * std::exp(-place[axis_of_altitude]);
}

/// What is the same wherever one stands in an air; made once an air.
class AirCoordinates {
public:
    explicit AirCoordinates(const AtmosphereParameters& parameters);
    /// Elevation in [-90, 90]; altitude above the ground, any finite number.
    [[nodiscard]] Situation at(double sun_elevation_deg, double altitude_m) const;

private:
    Situation air_{};
    double scale_height_m_, thickness_m_, radius_m_;
};

}  // namespace aureole::detail
