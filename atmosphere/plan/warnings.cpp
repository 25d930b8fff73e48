#include "plan/choices.h"

#include <algorithm>
#include <utility>

namespace aureole::detail {
namespace {

constexpr double nearest_geometry_m = 1000 * nearest_geometry_km, farthest_geometry_m = 1000 * farthest_geometry_km;

}  // namespace

std::vector<std::string> warnings_of(const PlanRequirements& requirements, const Plan& plan) {
    std::vector<std::string> warnings;
    if (plan.distance > 1) warnings.emplace_back("FAR from all scenes that were measured: the bound need not hold");
    const double range = requirements.geometry_range_m;
    if (plan.view.aerial_perspective && (range < nearest_geometry_m || range > farthest_geometry_m))
        warnings.push_back("geometry up to " + with_unit(range / 1000, "km") +
                           " away is FAR from what was measured, 1 to 100 km: the bound need not hold of it");
    if (requirements.budget_ms && requirements.speed == DeviceSpeed{})
        warnings.push_back("the budget in milliseconds is judged by the speed of " + plan.measured_on +
                           ", not of the device at hand (calibrate)");
    return warnings;
}

std::string exclusions(const std::vector<PlanCandidate>& candidates) {
    std::vector<std::pair<std::string, std::string>> reasons;  // and who has it
    for (const PlanCandidate& one : candidates) {
        if (one.excluded.empty()) continue;
        const auto known = std::ranges::find(reasons, one.excluded, &std::pair<std::string, std::string>::first);
        if (known == reasons.end())
            reasons.emplace_back(one.excluded, one.setting.id());
        else
            known->second += ", " + one.setting.id();
    }
    std::string text;
    for (const auto& [reason, settings] : reasons)
        text.append(text.empty() ? "" : "; ").append(reason).append(" (").append(settings).append(")");
    return text.empty() ? "nothing was measured" : text;
}

}  // namespace aureole::detail
