#include "passes/rig.h"

#include <aureole/models/aureole.h>

#include <cmath>
#include <numbers>

namespace aureole::passes {
namespace {

constexpr double degree = std::numbers::pi / 180;
// Not titan: in its air light is scattered dozens of times, which multiplies the rounding of floats beyond the bounds of the
// others.
constexpr const char* presets_in_use[] = {"earth", "hazy_earth", "mars", "airless", "us_standard_1976"};
constexpr double elevations[] = {90, 45, 10, 3, 0.5, 0, -0.5, -3, -6, -9, -12};

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

AirRig::AirRig(Backend& backend_in, const Setup& setup_in)
    : backend(backend_in),
      setup(setup_in),
      air(backend.device(), setup.air, setup.model ? setup.model : models::aureole(setup.quality)) {}

CommandCounts AirRig::record_air() {
    return backend.run([&](rhi::CommandList& commands) { air.record(commands); });
}

Rig::Rig(Backend& backend_in, const Setup& setup_in) : AirRig(backend_in, setup_in), view(air, setup.view, setup.composite) {}

CommandCounts Rig::record_view(const Camera& camera, std::span<const Sun> suns) {
    view.update(camera, suns);
    return backend.run([&](rhi::CommandList& commands) { view.record(commands); });
}

Image Rig::show(rhi::Extent extent, CompositeTargets targets) {
    const auto state = setup.composite.raster ? rhi::State::color_attachment : rhi::State::storage_write;
    targets.extent = extent;
    targets.target = backend.make_target(setup.composite.target_format, extent, state);
    view.prepare_composite(targets);
    backend.run([&](rhi::CommandList& commands) { view.record_composite(commands, targets); });
    return backend.read(targets.target, state);
}

std::span<const char* const> preset_names() { return presets_in_use; }

Sun sun_at(double elevation_deg) {
    Sun sun;
    sun.direction = {std::cos(elevation_deg * degree), 0, std::sin(elevation_deg * degree)};
    return sun;
}

Camera camera_at(const Planet& planet, double altitude_m) {
    return look(planet.bottom_radius_m, altitude_m, 40 * degree, -5 * degree, 60 * degree, 1.5);
}

std::span<const double> elevations_deg() { return elevations; }

std::vector<double> altitudes_m(const Planet& planet) {
    const double top = planet.top_radius_m - planet.bottom_radius_m;
    return {0, 0.01, 2, 1e3, 1e4, 1e5, top - 1, top + 1, 4e5, 1e6};
}

}  // namespace aureole::passes
