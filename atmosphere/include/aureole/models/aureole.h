// Our own model: Gauss nodes on the sunlit part of each ray, multiple scattering that keeps its direction, sky-view and froxels
// with the sharp phase functions kept out of the tables. See models/aureole/aureole.md.
#pragma once

#include <aureole/model.h>

namespace aureole::models {

/// Throws Error(invalid_argument) at the first setting outside its range.
[[nodiscard]] ModelPtr aureole(const QualitySettings& quality = QualitySettings::standard());

}  // namespace aureole::models
