// Fog: air that is the same everywhere, in closed form (Hoffman & Preetham, "Rendering Outdoor Light Scattering in Real Time",
// GDC 2002). The cheapest model: no table, no march. Its equations and when they fail: models/fog/fog.md.
#pragma once

#include <aureole/model.h>

namespace aureole::models {

/// A value out of range is Error(invalid_argument) from `validate` and `fog`.
struct FogSettings {
    /// What fog adds to what is behind it.
    enum class Mode : std::uint8_t {
        one_colour,  ///< L0 f + C (1 - f), f = exp(-density s): looks the same by day and night, towards the sun and away.
        in_scatter,  ///< The air that the camera stands in, without end: its scattering, extinction and phase functions.
    };
    /// Where a ray that meets nothing ends.
    enum class Sky : std::uint8_t {
        top_of_air,  ///< Planet::top_radius_m.
        infinity,  ///< Nowhere: the sky is the fog's own colour, and neither sun nor stars come through. For a camera above the
                   ///< air: as top_of_air.
    };
    Mode mode = Mode::in_scatter;  ///< What fog adds.
    Sky sky = Sky::top_of_air;     ///< Where a ray that meets nothing ends.
    /// C, one_colour alone: radiance of endless fog per unit of irradiance, summed over the suns as they are above the air:
    /// 1/sr. Each channel in [0, 1e6].
    Rgb colour{0.05, 0.06, 0.07};
    /// one_colour alone: extinction, 1/m, in [0, 1e3]. 1e-4: 2 % of what is seen 39 km away comes through.
    double density_per_m = 1e-4;
    /// Gauss nodes of the optical depth towards the sun, in [2, 16].
    int transmittance_nodes = 8;

    /// "low": one colour. "default": in-scatter. "high", "converged": the same with 16 nodes. Anything else:
    /// Error(invalid_argument).
    [[nodiscard]] static FogSettings by_name(std::string_view quality);
};

/// Throws Error(invalid_argument) at the first field outside its range.
void validate(const FogSettings& settings);

[[nodiscard]] ModelPtr fog(const FogSettings& settings = {});  ///< Closed-form fog. Throws Error naming a setting out of range.

}  // namespace aureole::models
