// Light for a host's own materials, as a View's light table holds it: by any model, and as it truly is.
#pragma once

#include "app/backend.h"
#include "app/trace.h"

#include <aureole/atmosphere.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

struct LightPlace {
    double sun_zenith_deg = 0;  ///< In [0, 180].
    double altitude_km = 0;     ///< Above the ground; in [-10, 1e9]. Below 0: as from the ground.
};

/// Both per unit of solar irradiance.
struct MeasuredLight {
    Rgb sun_irradiance{0};     ///< Of a surface that faces the sun (a disk of Sun's own radius).
    Rgb sky_irradiance_up{0};  ///< Of a horizontal surface: the sky's alone, as far as spherical harmonics of degree 2 tell it.
};

/// Paths of each of the light table's directions in a round of trace_light.
inline constexpr int light_round_paths = 16;

/// By LightTable at each place; every model has light. Throws Error(invalid_argument) naming the place (from 1).
[[nodiscard]] std::vector<MeasuredLight> light(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model,
                                               std::span<const LightPlace> places);
/// The same of an atmosphere whose tables have been recorded (app/solution.h).
[[nodiscard]] std::vector<MeasuredLight> light(Backend& backend, Atmosphere& air, std::span<const LightPlace> places);

struct LightTruth {
    Rgb sun_irradiance{0};        ///< By quadrature: without a standard error.
    Estimated sky_irradiance_up;  ///< `radiance` is the irradiance.
    std::uint64_t paths = 0;      ///< Of each of the light table's directions.
    bool reached = false;         ///< The error is as small as wanted; false where max_paths came first.
};

/// The same by path tracing, through the same directions and harmonics: light tables of light_round_paths paths a direction,
/// each with another seed, until the standard error of the sky's irradiance is as small as settings.error wants. Of the
/// settings max_paths is that of a direction (there are seeds for 65536), and orders is 0. `progress` is told how much is
/// done, in [0, 1]; none if `stop` says so, which is asked before each table. Errors as above, and of TraceSettings.
[[nodiscard]] std::optional<LightTruth> trace_light(Backend& backend, const AtmosphereParameters& parameters,
                                                    const LightPlace& place, const TraceSettings& settings,
                                                    const std::function<void(double)>& progress = {},
                                                    const std::function<bool()>& stop = {});

}  // namespace aureole::app
