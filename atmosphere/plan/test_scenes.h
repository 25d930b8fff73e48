// For tests: the plans of a measured scene beside the settings that were measured in it.
#pragma once

#include "plan/candidates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace aureole::detail {

/// Where the air before geometry is left out, no setting is judged by it.
inline PlanRequirements judged_by(PlanRequirements needs, AirBefore air) {
    needs.geometry = air == AirBefore::drawn;
    return needs;
}

/// Of the settings that were measured in this scene, within so much of the tolerance. Costs as measured in its air; as foretold
/// for it where they were not.
inline double cheapest_that_meets(const PlanRequirements& needs, const Predictor& predictor, std::size_t scene, double share,
                                  AirBefore air) {
    double cheapest = std::numeric_limits<double>::infinity();
    const MeasuredSkies& skies = predictor.skies();
    for (const MeasuredSetting& setting : skies.settings) {
        const std::optional<double> worst = measured_worst(judged_by(needs, air), setting, scene);
        if (!worst || *worst > share * *needs.tolerance) continue;
        MeasuredCost cost = setting.by_air[skies.scenes[scene].air];
        if (cost.air_mib == 0) {
            const Prepared prepared = prepare(setting.setting, needs.air).value();
            const auto foretold =
                predictor.cost(setting, skies.scenes[scene].situation, table_work(*prepared.model, prepared.air));
            if (!foretold) continue;  // no plan takes it
            cost = *foretold;
        }
        cheapest = std::min(cheapest, cost_of(needs, cost, air).cost.charged_ms);
    }
    return cheapest;
}

struct Planned {
    std::size_t planned = 0, refused = 0;
};

/// `needs` for a scene of that air: for every tolerance from half a percent to 20 % the plan is the cheapest measured setting
/// that meets it, or within 15 % of that cost.
inline Planned check_plans_of(PlanRequirements needs, const Predictor& predictor, std::size_t scene) {
    const MeasuredScene& at = predictor.skies().scenes[scene];
    needs.sun_elevation_deg = {at.sun_elevation_deg, at.sun_elevation_deg};
    needs.altitude_m = {at.altitude_m, at.altitude_m};
    Planned count;
    for (const double tolerance : std::array{0.005, 0.0075, 0.01, 0.015, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2}) {
        needs.tolerance = tolerance;
        const Plan found = plan(needs);
        INFO(at.id, " at ", tolerance, needs.geometry ? " with geometry" : "", needs.light ? " and light" : "", ": ",
             found.setting.id());
        CHECK(found.distance < 0.01);
        const AirBefore air = needs.geometry && !found.view.aerial_perspective ? AirBefore::left_out : air_asked_for(needs);
        // Errors are kept in thousandths of their logarithm: what is right on the tolerance may fall on either side.
        const double cheapest = cheapest_that_meets(needs, predictor, scene, 0.99, air);
        if (std::isfinite(cheapest)) CHECK(found.tolerable);
        ++(found.tolerable ? count.planned : count.refused);
        if (!found.tolerable) continue;
        CHECK(std::max(found.error.p95, found.error.light) <= 1.01 * tolerance);
        CHECK(found.cost.charged_ms <= 1.15 * cheapest);
        // Unless it takes one that was measured elsewhere, and is foretold to be good enough here.
        const auto chosen = std::ranges::find(predictor.skies().settings, found.setting, &MeasuredSetting::setting);
        if (measured_worst(judged_by(needs, air), *chosen, scene))
            CHECK(found.cost.charged_ms >= 0.999 * cheapest_that_meets(needs, predictor, scene, 1.01, air));
    }
    return count;
}

}  // namespace aureole::detail
