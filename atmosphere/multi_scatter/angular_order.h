// How many moments of the diffuse field an air can make use of.
#pragma once

#include <aureole/parameters.h>

#include <vector>

namespace aureole::detail {

/// By degree l, from 0 to 10: the sum over terms of vertical scattering optical depth times |p_l|, in the channel where it is
/// greatest.
[[nodiscard]] std::vector<double> scattered_moments(const AtmosphereParameters& parameters);

/// The least of 0, 2, 4 and 8 that is enough for this air, at most `most`: moments of a degree l matter as much as the air
/// scatters by phase functions that have that degree, so what counts is the vertical optical depth of scattering times the
/// phase moment p_l, summed over phase functions, for the first two degrees left out. Below `negligible_moment(most)` they are
/// left out.
[[nodiscard]] int angular_order_for(const AtmosphereParameters& parameters, int most);

/// Who asks for more moments wants less to be left out. Measured at the presets: Earth's clear air has 0.0028 at l = 3 and
/// 0.0018 at l = 5; with L = 2 the sky near the horizon is off by up to 1 %, which is what else `default` errs by, but twice
/// what `high` does with L = 4. Hazy Earth has ten times as much, Mars twenty.
[[nodiscard]] constexpr double negligible_moment(int most) { return most <= 4 ? 0.006 : 0.002; }

}  // namespace aureole::detail
