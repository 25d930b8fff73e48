// Small tables, and where and when passes are compared.
#pragma once

#include <aureole/camera.h>
#include <aureole/parameters.h>
#include <aureole/quality.h>

namespace aureole::passes {

/// Small tables of odd shapes: no side is a multiple of a workgroup's, none is square.
[[nodiscard]] QualitySettings small_quality();

/// The sun at an elevation, towards +x, seen from the +z pole.
[[nodiscard]] Sun sun_at(double elevation_deg);
/// At an altitude over the +z pole, looking a little below the horizon and 40 degrees away from the sun.
[[nodiscard]] Camera camera_at(const Planet& planet, double altitude_m);

}  // namespace aureole::passes
