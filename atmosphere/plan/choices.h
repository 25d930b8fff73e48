// Why a plan is as it is: each decision with the figures behind it.
#pragma once

#include "plan/candidates.h"

#include <string>
#include <vector>

namespace aureole::detail {

/// Of a plan whose setting, air, model, view, figures and candidates are known. `place`: any in its air; `seen`: what its
/// candidates are from.
[[nodiscard]] std::vector<PlanChoice> choices_of(const PlanRequirements& requirements, const Predictor& predictor,
                                                 const Situation& place, const Outlook& seen, const Plan& plan);

/// "1.27 MiB": three figures.
[[nodiscard]] std::string with_unit(double value, const char* unit);
/// "4.2 %": two figures.
[[nodiscard]] std::string percent(double share);
/// "12.3 ms": three figures.
[[nodiscard]] std::string milliseconds(double ms);
/// "0.52 times": two figures.
[[nodiscard]] std::string times(double factor);

/// Plan::warnings, of a plan whose other figures are known.
[[nodiscard]] std::vector<std::string> warnings_of(const PlanRequirements& requirements, const Plan& plan);
/// Why each candidate cannot be taken: "has no shadows in the air (fog default, fog low); was not measured (...)".
[[nodiscard]] std::string exclusions(const std::vector<PlanCandidate>& candidates);

}  // namespace aureole::detail
