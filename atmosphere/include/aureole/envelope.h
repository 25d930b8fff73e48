// The envelope of stability: how far the numbers of a scene may go for every model, in float on every device, to be within 1 %
// of the same model in double (0.1 % at altitudes of 1 m to 1000 km on Earth), each number alone being varied from Earth's.
// Measured, and with what remains outside and why: docs/stability.md. `validate` accepts more; what lies between gives finite
// numbers that are not negative, but not as exact ones.
//
// Atmosphere and View tell the log, as a warning, what is outside: once when it is set, not in every frame.
#pragma once

#include <aureole/camera.h>
#include <aureole/parameters.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole {

/// What has an end within what `validate` accepts. All else may be all of that: the ground's albedo and single scattering's
/// from 0 to 1, suns at any elevation, of any radius, irradiance and number, sizes of tables.
enum class EnvelopeAxis : std::uint8_t {
    bottom_radius_m,
    shell_over_radius,       ///< Thickness of the air over the planet's radius.
    scale_height_m,          ///< Of an exponential profile.
    extinction_per_m,        ///< All terms together, at their greatest densities.
    g,                       ///< Of any phase function by a formula.
    altitude_m,              ///< Of the camera.
    half_sun_elevation_deg,  ///< Above the camera's horizontal, for models that keep the camera's sky in half floats.
    half_difference_sun_elevation_deg,  ///< The same, of geometry whose air is a difference of entries of tables in half
                                        ///< floats: by `bruneton`.
    table_sun_elevation_deg,  ///< The same, of `bruneton` on planets of more than 7000 km and in air of more than 1 per km.
};
/// What of a view comes from tables that end in twilight. All false: a model that has none.
struct KeptInTables {
    bool half_sky = false;         ///< The camera's sky, in half floats.
    bool half_difference = false;  ///< In half floats, and the air before geometry is two entries' difference.
    bool coarse_sun_axis = false;  ///< All light, by an axis of the sun's cosine too coarse for deep twilight.
};
/// Within which one number may go.
struct EnvelopeLimit {
    double least = 0, greatest = 0;  ///< In the axis's unit.
    std::string_view beyond;         ///< What to expect outside, and why.
};
[[nodiscard]] const EnvelopeLimit& envelope_limit(EnvelopeAxis axis);  ///< What is inside along one axis.

/// A number that is outside.
struct OutsideEnvelope {
    std::string field;                          ///< As errors name it: "terms[1].phase.g".
    double value = 0, least = 0, greatest = 0;  ///< What was given, and what is inside.
    std::string_view beyond;                    ///< Of the limit.
    /// "terms[1].phase.g: 0.995 is outside the envelope of stability, [-0.99, 0.99]: expect ..."
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool operator==(const OutsideEnvelope&) const = default;
};
/// Of an air that `validate` accepts. Empty: all inside.
[[nodiscard]] std::vector<OutsideEnvelope> outside_envelope(const AtmosphereParameters& parameters);
/// Of a camera and suns that `validate` accepts, at this planet. Nothing is allocated where all is inside.
[[nodiscard]] std::vector<OutsideEnvelope> outside_envelope(const Planet& planet, const Camera& camera,
                                                            std::span<const Sun> suns, const KeptInTables& kept = {});

}  // namespace aureole
