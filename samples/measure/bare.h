// Geometry that is shown as the host drew it, without the air before it: how far that is from the truth, by its distance.
#pragma once

#include "measure/compare.h"
#include "plan/measured.h"

#include <array>

namespace aureole::app {

struct BareError {
    ErrorSummary error;
    std::size_t asked = 0;  ///< Pixels, those included whose truth is too noisy.
};
using BareErrors = std::array<BareError, detail::bare_distances_km.size()>;

/// At each of detail::bare_distances_km, of a place with an aerial view. By the true radiance of the pixels whose geometry is
/// there or up to three times as far (nearer than 1 km: of those from there on), each brought to that very distance: what the
/// air adds and takes along a ray goes with 1 - exp(-optical depth), which is exact where the light that the air is in does not
/// change along the way. No model is needed: what is shown is the same in all of them.
[[nodiscard]] BareErrors bare_errors(const AtmosphereParameters& air, const Place& place);

/// What a ray shows at `nearer_km`, from the `truth` at its pixel's own distance, which is no less: geometry of radiance
/// `shown`.
[[nodiscard]] Rgb brought_nearer(const AtmosphereParameters& air, double altitude_km, const AerialPixel& pixel,
                                 double nearer_km, const Rgb& shown, const Rgb& truth);

}  // namespace aureole::app
