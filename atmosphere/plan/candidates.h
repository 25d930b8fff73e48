// Every measured setting under the requirements of a plan: how far from the truth it will be, and what it will cost.
#pragma once

#include "plan/measured.h"
#include "plan/predict.h"

#include <aureole/plan.h>

#include <vector>

namespace aureole::detail {

/// Places that stand for the ranges: their ends, some between, and every elevation between that was measured.
[[nodiscard]] std::vector<Situation> situations_of(const PlanRequirements& requirements, const MeasuredSkies& skies);

/// All of `skies`, in their order. `predictor` is one of them.
[[nodiscard]] std::vector<PlanCandidate> candidates_of(const PlanRequirements& requirements, const MeasuredSkies& skies,
                                                       Predictor& predictor);

/// Of a frame, and of its parts that a view can do without, for one candidate.
struct CostParts {
    PlanCost cost;
    /// Of all views: in cost.frame_ms where they are needed.
    double aerial_perspective_ms = 0, light_ms = 0, shadows_ms = 0;
};
[[nodiscard]] CostParts cost_of(const PlanRequirements& requirements, const MeasuredCost& measured);

/// Index of the candidate that a plan takes: the cheapest that is tolerable, or (without a tolerance) the most accurate that
/// is; of those that cost the same within a tenth, or are as accurate, the better. If none is tolerable, the most accurate
/// within the budgets, else the one that breaks them least. At least one is not excluded.
[[nodiscard]] std::size_t best_of(const PlanRequirements& requirements, const std::vector<PlanCandidate>& candidates);

}  // namespace aureole::detail
