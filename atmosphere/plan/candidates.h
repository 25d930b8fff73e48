// Every measured setting under the requirements of a plan: how far from the truth it will be, and what it will cost.
#pragma once

#include "plan/measured.h"
#include "plan/predict.h"

#include <aureole/plan.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace aureole::detail {

/// Places that stand for the ranges: their ends, some between, every elevation and altitude between that was measured with
/// those of the other, and every measured scene. At least one; each once.
[[nodiscard]] std::vector<Situation> situations_of(const PlanRequirements& requirements, const MeasuredSkies& skies);

/// What becomes of the air before the host's geometry.
enum class AirBefore : std::uint8_t {
    nothing,   ///< There is no geometry.
    drawn,     ///< Aerial perspective.
    left_out,  ///< Geometry is shown as the host drew it.
};
[[nodiscard]] inline AirBefore air_asked_for(const PlanRequirements& requirements) {
    return requirements.geometry ? AirBefore::drawn : AirBefore::nothing;
}

/// What plan() does with the air before geometry that errs by `bare` without it: it is left out where all that it changes is
/// within the tolerance, unless shadows are to be seen in it, or `keep_air`.
[[nodiscard]] AirBefore choose_air(const PlanRequirements& requirements, const std::optional<PredictedError>& bare,
                                   bool keep_air = false);
/// Where the air before geometry is left out, no setting is judged by it.
[[nodiscard]] inline PlanRequirements judged_by(PlanRequirements requirements, AirBefore air) {
    requirements.geometry = air == AirBefore::drawn;
    return requirements;
}
/// The worse of what a view shows beside geometry, and of that.
[[nodiscard]] PlanError worse_of(PlanError error, const PredictedError& geometry);

/// What a setting errs by in a place, by what a view shows and its materials need, if that is worse than `so_far`; none where
/// it is not known. Geometry is seen through the air. Errors of light are left aside above the air, where it is the sun's
/// alone, and in tables without any.
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
    AirBefore air = AirBefore::nothing;     ///< That the candidates are for.
    /// What geometry without the air before it errs by, in the worst of the places; none where that is not known.
    std::optional<PredictedError> bare;
    /// Where there is geometry: the bound of each candidate if the air before it were left out where it is drawn, and drawn
    /// where it is left out; none where that is not known.
    std::vector<std::optional<double>> bound_otherwise;
};
/// At least one place. The air before geometry as choose_air says.
[[nodiscard]] Outlook outlook(const PlanRequirements& requirements, const Predictor& predictor,
                              const std::vector<Situation>& places, bool keep_air = false);

/// Upper bound of what shadows in the air err by, of the light that is there without them, in 95 of 100 directions in 95 of
/// 100 scenes; in [0, 1]; none where it is not known. Light that was scattered more than once is not shadowed: as if all of it
/// had to be; and what their march errs by.
[[nodiscard]] std::optional<double> shadows_bound(const PlanRequirements& requirements, const Predictor& predictor,
                                                  const std::vector<Situation>& places);

/// Of a frame, and of its parts that a view can do without, for one candidate.
struct CostParts {
    PlanCost cost;
    /// Of all views: in cost.frame_ms where they are needed.
    double aerial_perspective_ms = 0, light_ms = 0, shadows_ms = 0;
};
[[nodiscard]] CostParts cost_of(const PlanRequirements& requirements, const MeasuredCost& measured, AirBefore air);
[[nodiscard]] inline CostParts cost_of(const PlanRequirements& requirements, const MeasuredCost& measured) {
    return cost_of(requirements, measured, air_asked_for(requirements));
}

/// Index of the candidate that a plan takes: the cheapest that is tolerable, or (without a tolerance) the most accurate that
/// is; of those that cost the same within a tenth, or are as accurate, the better. If none is tolerable, the most accurate
/// within the budgets, else the one that breaks them least. At least one is not excluded.
[[nodiscard]] std::size_t best_of(const PlanRequirements& requirements, const std::vector<PlanCandidate>& candidates);

}  // namespace aureole::detail
