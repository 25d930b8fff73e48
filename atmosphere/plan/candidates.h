// Every measured setting under the requirements of a plan: how far from the truth it will be, and what it will cost.
#pragma once

#include "plan/measured.h"
#include "plan/predict.h"

#include <aureole/plan.h>

#include <optional>
#include <vector>

namespace aureole::detail {

/// Places that stand for the ranges: their ends, some between, every elevation and altitude between that was measured with
/// those of the other, and every measured scene. At least one; each once.
[[nodiscard]] std::vector<Situation> situations_of(const PlanRequirements& requirements, const MeasuredSkies& skies);

/// What a setting errs by in a place, by what a view shows and its materials need, if that is worse than `so_far`; none where
/// it is not known. Errors of light are left aside above the air, where it is the sun's alone, and in tables without any.
[[nodiscard]] std::optional<PlanError> worse(const PlanRequirements& requirements, const MeasuredSetting& setting,
                                             Predictor::Here& here, const PlanError& so_far);
/// What was measured of a setting in a scene of all that its bound is of: the worst; none where a part of it is not known.
[[nodiscard]] std::optional<double> measured_worst(const PlanRequirements& requirements, const MeasuredSetting& setting,
                                                   std::size_t scene);
/// Whether a candidate meets tolerance and budgets.
[[nodiscard]] bool tolerates(const PlanRequirements& requirements, const PlanCandidate& candidate);

/// Every measured setting in some places, and the one of these that is least like any that was measured.
struct Outlook {
    std::vector<PlanCandidate> candidates;  ///< In the order of MeasuredSkies::settings.
    double distance = 0;                    ///< Of that place.
    std::vector<std::size_t> nearest;       ///< Scenes, to that place.
};
/// At least one place.
[[nodiscard]] Outlook outlook(const PlanRequirements& requirements, const Predictor& predictor,
                              const std::vector<Situation>& places);

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
