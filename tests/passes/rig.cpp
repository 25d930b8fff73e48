#include "passes/rig.h"

#include <aureole/models/aureole.h>

namespace aureole::passes {
namespace {

// Not titan: in its air light is scattered dozens of times, which multiplies the rounding of floats beyond the bounds of the
// others.
constexpr const char* presets_in_use[] = {"earth", "hazy_earth", "mars", "airless", "us_standard_1976"};
constexpr double elevations[] = {90, 45, 10, 3, 0.5, 0, -0.5, -3, -6, -9, -12};

}  // namespace

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

std::span<const double> elevations_deg() { return elevations; }

std::vector<double> altitudes_m(const Planet& planet) {
    const double top = planet.top_radius_m - planet.bottom_radius_m;
    return {0, 0.01, 2, 1e3, 1e4, 1e5, top - 1, top + 1, 4e5, 1e6};
}

}  // namespace aureole::passes
