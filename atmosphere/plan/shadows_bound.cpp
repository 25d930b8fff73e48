#include "plan/candidates.h"

#include "shadows/shadows.h"

#include <algorithm>

namespace aureole::detail {
namespace {

/// What it errs by is the light that was scattered more than once.
const MeasuredSetting* single_scattering(const MeasuredSkies& skies) {
    const auto found = std::ranges::find_if(skies.settings, [](const MeasuredSetting& one) {
        return one.setting.without == std::vector<std::string>{"multiple scattering"};
    });
    return found == skies.settings.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> shadows_bound(const PlanRequirements& requirements, const Predictor& predictor,
                                    const std::vector<Situation>& places) {
    const MeasuredSetting* single = single_scattering(predictor.skies());
    if (single == nullptr) return {};
    PlanRequirements seen = requirements;
    seen.light = false;  // materials have shadows of the host's own
    PlanError worst;
    for (const Situation& place : places) {
        Predictor::Here here = predictor.at(place);
        const std::optional<PlanError> found = worse(seen, *single, here, worst);
        if (!found) return {};
        worst = *found;
    }
    return std::min(worst.bound + shadows_march_error, 1.0);
}

}  // namespace aureole::detail
