// Pictures of all that is around a scene's camera, from the zenith to the nadir, for eyes that compare.
#pragma once

#include "io/image.h"
#include "measure/suite.h"
#include "measure/truth.h"

#include <span>
#include <string>
#include <vector>

namespace aureole::app {

/// Half of one is the mirror image of the other: the sun is in the middle.
inline constexpr std::uint32_t picture_width = 64, picture_height = 32;

/// Directions of the half on one side of the sun, row by row from the top, picture_width / 2 in each: through the middles of
/// pixels.
[[nodiscard]] std::vector<ProbeRow> picture_rows(const SuiteScene& scene);

/// Radiances of those directions as a picture: times the exposure, linear, both halves.
[[nodiscard]] LinearImage picture_of(std::span<const Rgb> radiance, double exposure);
/// Of each pixel the difference from the truth in CIEDE2000, as a colour: 0 black, 2.5 violet, 5 red, 7.5 yellow, 10 and more
/// white.
[[nodiscard]] LinearImage difference_of(std::span<const Rgb> radiance, std::span<const Rgb> truth, double exposure);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

}  // namespace aureole::app
