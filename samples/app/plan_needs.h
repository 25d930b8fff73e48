// What a scene asks of the planner.
#pragma once

#include "scene/scene.h"

#include <aureole/plan.h>

namespace aureole::app {

/// Its air, suns, camera and picture. What is tolerable is the caller's to say.
[[nodiscard]] PlanRequirements plan_needs(const Scene& scene);

}  // namespace aureole::app
