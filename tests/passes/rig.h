// One atmosphere and one view on a backend, small tables, and the places and hours at which passes are compared.
#pragma once

#include <aureole/atmosphere.h>
#include <aureole/models/aureole.h>
#include <aureole/presets.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "passes/backend.h"
#include "rhi/place.h"

namespace aureole::passes {

struct Setup {
    AtmosphereParameters air = presets::earth();
    QualitySettings quality = small_quality();
    ModelPtr model = nullptr;  ///< Null: the model `aureole` with `quality`.
    ViewSettings view{};
    CompositeSettings composite{};
};

/// An atmosphere alone.
class AirRig {
public:
    AirRig(Backend& backend, const Setup& setup);

    CommandCounts record_air();
    [[nodiscard]] Image transmittance() { return backend.read(air.transmittance_table()); }
    [[nodiscard]] Image multi_scatter() { return backend.read(air.multi_scatter_table()); }

    Backend& backend;
    const Setup setup;
    Atmosphere air;
};

class Rig : public AirRig {
public:
    Rig(Backend& backend, const Setup& setup);

    /// Updates and records the view.
    CommandCounts record_view(const Camera& camera, std::span<const Sun> suns);
    CommandCounts record_view(const Camera& camera, const Sun& sun) { return record_view(camera, std::span(&sun, 1)); }
    /// What the composite shows of the view as it was last recorded, in a target of the composite's format.
    Image show(rhi::Extent extent, CompositeTargets targets = {});

    [[nodiscard]] Image sky_view() { return backend.read(view.sky_view_table()); }
    [[nodiscard]] Image froxels() { return backend.read(view.aerial_perspective_table()); }
    [[nodiscard]] Image light() { return backend.read(view.light_table()); }

    View view;
};

/// The presets by name that every pass is compared for.
[[nodiscard]] std::span<const char* const> preset_names();

/// Elevations from 90 to -12 degrees; altitudes from the ground to 1000 km, with both sides of the top.
[[nodiscard]] std::span<const double> elevations_deg();
[[nodiscard]] std::vector<double> altitudes_m(const Planet& planet);

}  // namespace aureole::passes
