// Checks that other rooms share.
#pragma once

#include <aureole/parameters.h>

#include <string>

#include "common/check.h"

namespace aureole::detail {

/// Throws Error(invalid_argument) naming "<field>.g" and the like.
void check_phase(const std::string& field, const PhaseFunction& phase);
/// `field` is "planet".
void check_planet(const std::string& field, const Planet& planet);
/// `field` is "sun", or "suns[1]".
void check_sun(const FieldName& field, const Sun& sun);

}  // namespace aureole::detail
