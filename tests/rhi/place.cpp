#include "rhi/place.h"

#include <cmath>
#include <numbers>

namespace aureole::passes {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

QualitySettings small_quality() {
    QualitySettings quality;
    quality.name = "small";
    quality.transmittance = {40, 12, 1};
    quality.multi_scatter = {10, 6, 1};
    quality.angular_order = 2;
    quality.angular_order_as_needed = false;
    quality.multi_scatter_zenith = 3;
    quality.multi_scatter_nodes = 6;
    quality.sky_view = {10, 22, 1};
    quality.sky_view_nodes = 6;
    quality.aerial_perspective = {9, 7, 6};
    quality.froxel_format = rhi::Format::rgba32_float;
    return quality;
}

Sun sun_at(double elevation_deg) {
    Sun sun;
    sun.direction = {std::cos(elevation_deg * degree), 0, std::sin(elevation_deg * degree)};
    return sun;
}

Camera camera_at(const Planet& planet, double altitude_m) {
    return look(planet.bottom_radius_m, altitude_m, 40 * degree, -5 * degree, 60 * degree, 1.5);
}

}  // namespace aureole::passes
