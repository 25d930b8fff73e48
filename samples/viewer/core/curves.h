// What the viewer plots of an air: its profiles, and how much of the sun's beam gets through it.
#pragma once

#include "app/backend.h"

#include <aureole/atmosphere.h>

#include <vector>

namespace aureole::viewer {

struct Curves {
    // Over altitude, from the ground to the top of the air or to ten times the greatest scale height, if that is less.
    std::vector<double> altitude_m;
    std::vector<Rgb> scattering_per_m, extinction_per_m;
    // Over the elevation of a sun, at the camera: the share of its light that arrives, as the model's own light pass has it.
    std::vector<double> sun_elevation_deg;
    std::vector<Rgb> transmittance;
};

/// Profiles alone.
[[nodiscard]] Curves profiles_of(const AtmosphereParameters& air);
/// Profiles, and transmittance at this altitude above the ground radius. `air` has been recorded.
[[nodiscard]] Curves curves_of(app::Backend& backend, Atmosphere& air, double altitude_m);

}  // namespace aureole::viewer
