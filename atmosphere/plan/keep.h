// Plans beside a setting that is in use: another one costs a rebuild, and a fade.
#pragma once

#include <aureole/plan.h>

namespace aureole::detail {

/// In these `keep_air` keeps aerial perspective where there is geometry, also where it could be left out.

/// As plan(), but `incumbent` where that meets the requirements too, and costs at most a tenth more than what plan() takes;
/// without a tolerance, or if nothing meets them, also errs at most a tenth more. Throws as plan() does.
[[nodiscard]] Plan plan_keeping(const PlanRequirements& requirements, const Setting& incumbent, bool keep_air = false);

/// With this setting, whatever it costs. It is a candidate that is not excluded; else as plan().
[[nodiscard]] Plan plan_of(const PlanRequirements& requirements, const Setting& setting, bool keep_air = false);

}  // namespace aureole::detail
