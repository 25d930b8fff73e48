// Shared by what weighs spectra with the eye.
#pragma once

namespace aureole::spectrum::detail {

/// lm/W, at 540 THz.
inline constexpr double max_luminous_efficacy = 683;

}  // namespace aureole::spectrum::detail
