// Where sun and camera are, as far as a plan goes by it: on the scales of plan/axes.h.
#pragma once

#include <aureole/plan.h>

#include <span>

namespace aureole::detail {

/// Suns below this elevation, in degrees, light nothing that is planned for: astronomical twilight ends there.
inline constexpr double night_deg = -18;

struct Place {
    double lowest_sun = 0, highest_sun = 0;  ///< Of all that give light and are above night_deg; if none is: that.
    double altitude = 0;
};

/// Without suns those of `before`: night changes nothing. Valid camera and suns.
[[nodiscard]] Place place_of(const Planet& planet, const Camera& camera, std::span<const Sun> suns, const Place& before);

/// Whether each is within `margin` of where it is there.
[[nodiscard]] bool near(const Place& a, const Place& b, double margin);

/// The part of the requirements' ranges within `margin` of a place, and the place itself.
[[nodiscard]] PlanRequirements around(const PlanRequirements& needs, const Place& place, double margin);

}  // namespace aureole::detail
