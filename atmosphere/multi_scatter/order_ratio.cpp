#include "multi_scatter/order_ratio.h"

#include <algorithm>
#include <cmath>

namespace aureole::detail {
namespace {

/// 2 E_3(t): share of diffuse light from one side that passes a layer of optical depth t. t > 0.
double diffuse_transmittance(double t) { return std::exp(-t) * (1 - t) - t * t * std::expint(-t); }

double order_ratio(double depth, double scattering_depth, double ground_albedo) {
    if (depth < 1e-6) return 0;
    const double caught = 1 - diffuse_transmittance(depth);
    const double leaving = std::min(caught / (2 * depth), 1.0);
    return scattering_depth / depth * (1 - leaving * (1 - 0.5 * ground_albedo * caught));
}

}  // namespace

double order_ratio(const AtmosphereParameters& parameters, bool ground_light) {
    AtmosphereParameters scattering = parameters;
    for (DensityTerm& term : scattering.terms) term.absorption_per_m = Rgb(0);
    const Rgb depth = vertical_optical_depth(parameters), scattering_depth = vertical_optical_depth(scattering);
    const Rgb albedo = ground_light ? parameters.planet.ground_albedo : Rgb(0);
    double result = 0;
    for (int c = 0; c < 3; ++c) result = std::max(result, order_ratio(depth[c], scattering_depth[c], albedo[c]));
    return std::min(result, 1.0);
}

int passes_for(double ratio, int orders) {
    constexpr double clear = 0.4;
    if (ratio <= clear) return orders;
    const double passes = ratio < 1 ? orders * std::log(clear) / std::log(ratio) : 64;
    return std::max(orders, static_cast<int>(std::min(std::ceil(passes), 64.0)));
}

double greatest_ratio(double ratio) { return std::clamp((1 + 2 * ratio) / 3, 0.5, 0.98); }

}  // namespace aureole::detail
