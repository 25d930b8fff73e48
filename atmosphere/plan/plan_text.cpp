#include "plan/choices.h"

#include <algorithm>

namespace aureole {
namespace {

using detail::milliseconds;
using detail::percent;

std::string figures(const PlanCandidate& one) {
    return "p95 " + percent(one.error.p95) + ", below " + percent(one.error.bound) + ", " + milliseconds(one.cost.charged_ms);
}

/// Those that are next in cost on either side.
std::string neighbours(const Plan& plan) {
    std::string text;
    const auto chosen = std::ranges::find(plan.candidates, plan.setting, &PlanCandidate::setting);
    if (chosen == plan.candidates.end()) return text;
    if (chosen != plan.candidates.begin()) {
        const PlanCandidate& cheaper = *(chosen - 1);
        text += "next cheaper: " + cheaper.setting.id() + " (" + figures(cheaper) + ")\n";
    }
    const auto dearer = std::find_if(chosen + 1, plan.candidates.end(), [&](const PlanCandidate& one) {
        return one.excluded.empty() && one.error.bound < plan.error.bound;
    });
    if (dearer != plan.candidates.end()) text += "next better: " + dearer->setting.id() + " (" + figures(*dearer) + ")\n";
    return text;
}

}  // namespace

std::string Plan::text() const {
    std::string text = "plan: " + setting.id() + (tolerable ? "" : " (does NOT meet the requirements)") + "\n";
    text += "error of radiance: median " + percent(error.median) + ", 95th percentile " + percent(error.p95) + ", below " +
            percent(error.bound) + " in 95 cases of 100\n";
    if (error.light > 0) text += "error of light for materials: " + percent(error.light) + ", below the same bound\n";
    if (shadows_bound)
        text += "error of shadows in the air: below " + percent(*shadows_bound) +
                " of the unshadowed light for 95 of 100 directions in 95 cases of 100, in no other figure\n";
    text += "cost: " + milliseconds(cost.frame_ms) + " a frame, " + milliseconds(cost.rebuild_ms) + " a rebuild of the air, " +
            detail::with_unit(cost.mebibytes, "MiB") + " of tables\n";
    for (const PlanChoice& choice : choices) text += "  " + choice.what + ": " + choice.chosen + " (" + choice.reason + ")\n";
    text += neighbours(*this);
    text += "by the measured scenes";
    for (std::size_t i = 0; i < nearest.size(); ++i) text += (i == 0 ? " " : ", ") + nearest[i];
    text += "\ncosts as on " + measured_on;
    text += speed == DeviceSpeed{} ? ", not calibrated for another device\n"
                                   : ", calibrated: composites take " + detail::times(speed.composite) + ", tables " +
                                         detail::times(speed.tables) + " as long\n";
    for (const std::string& warning : warnings) text += "warning: " + warning + "\n";
    return text;
}

}  // namespace aureole
