// An air for tests of transmittances: a planet of 100 km, gas and a layer that absorbs.
#pragma once

#include <aureole/presets.h>

namespace aureole {

inline AtmosphereParameters small_planet() {
    AtmosphereParameters air = presets::earth();
    air.planet.bottom_radius_m = 50e3;
    air.planet.top_radius_m = 80e3;
    air.terms = {{"gas", ExponentialProfile{4e3}, Rgb(2e-5, 5e-5, 1e-4), Rgb(0), RayleighPhase{}},
                 {"layer", TentProfile{12e3, 6e3}, Rgb(0), Rgb(1e-5, 5e-5, 2e-6), RayleighPhase{}}};
    return air;
}

}  // namespace aureole
