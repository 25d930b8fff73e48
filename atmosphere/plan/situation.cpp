#include "plan/situation.h"

#include "multi_scatter/angular_order.h"
#include "multi_scatter/order_ratio.h"
#include "plan/axes.h"

#include <algorithm>
#include <cmath>

namespace aureole::detail {
namespace {

constexpr double least_depth = 0.01, least_absorption = 0.005, most_scale_heights = 8;

double mean(const Rgb& c) { return (c.r + c.g + c.b) / 3; }

/// Of extinction: the depth of the column over what there is of it at its densest, of a few altitudes.
double scale_height(const AtmosphereParameters& parameters, double thickness_m) {
    double densest = 0;
    for (int i = 0; i < 64; ++i)
        densest = std::max(densest, mean(sample_medium(parameters, thickness_m * i / 64).extinction_per_m));
    const double depth = mean(vertical_optical_depth(parameters));
    return densest > 0 && depth > 0 ? std::clamp(depth / densest, thickness_m / 64, thickness_m) : thickness_m;
}

}  // namespace

double densest_extinction_per_m(const AtmosphereParameters& parameters) {
    const double thickness_m = parameters.planet.top_radius_m - parameters.planet.bottom_radius_m;
    return mean(vertical_optical_depth(parameters)) / scale_height(parameters, thickness_m);
}

std::optional<double> densest_extinction_per_m(const Situation& place, double altitude_m) {
    const double scale_heights = place[axis_of_altitude];
    if (!(scale_heights > 0 && scale_heights < most_scale_heights)) return {};
    const double depth = std::exp(place[axis_of_depth]) - least_depth + std::exp(place[axis_of_absorption]) - least_absorption;
    return std::max(depth, 0.0) / altitude_m * scale_heights;
}

AirCoordinates::AirCoordinates(const AtmosphereParameters& parameters)
    : thickness_m_(parameters.planet.top_radius_m - parameters.planet.bottom_radius_m),
      radius_m_(parameters.planet.bottom_radius_m) {
    scale_height_m_ = scale_height(parameters, thickness_m_);
    AtmosphereParameters scattering = parameters;
    for (DensityTerm& term : scattering.terms) term.absorption_per_m = Rgb(0);
    const double extinction = mean(vertical_optical_depth(parameters)), depth = mean(vertical_optical_depth(scattering));
    const double sharp = scattered_moments(parameters)[3];
    air_ = {0,
            0,
            0,
            std::log(least_depth + depth),
            std::log(0.002 + sharp),
            std::log(least_absorption + std::max(extinction - depth, 0.0)),
            extinction > 0 ? 4 * depth / extinction : 4,
            4 * order_ratio(parameters),
            2 * mean(parameters.planet.ground_albedo),
            std::log(scale_height_m_ / radius_m_)};
}

Situation AirCoordinates::at(double sun_elevation_deg, double altitude_m) const {
    Situation result = air_;
    const double altitude = std::max(altitude_m, 0.0);
    result[axis_of_sun] = sun_axis(sun_elevation_deg);
    result[axis_of_altitude] = std::min(altitude / scale_height_m_, most_scale_heights);
    result[axis_of_space] = std::log1p(20 * std::max(altitude - thickness_m_, 0.0) / radius_m_);
    return result;
}

}  // namespace aureole::detail
