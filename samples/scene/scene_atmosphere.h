// The [atmosphere] section of a scene file.
#pragma once

#include "scene/section.h"

#include <aureole/parameters.h>

namespace aureole::app {

/// A preset with changes, or an atmosphere from scratch; validated. Errors point to the lines of the file.
[[nodiscard]] AtmosphereParameters read_atmosphere(Section section);

}  // namespace aureole::app
