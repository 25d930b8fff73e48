// For tests: the plans of a measured scene beside the settings that were measured in it.
#pragma once

#include "plan/candidates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace aureole::detail {

/// What geometry without the air before it was measured to err by in this scene; none where it was not, and where the range is
/// none of bare_distances_km.
inline std::optional<double> measured_bare(const PlanRequirements& needs, const MeasuredSkies& skies, std::size_t scene) {
    const double km = needs.geometry_range_m / 1000;
    const double extinction = extinction_per_m(densest_extinction_per_m(needs.air), skies.scenes[scene].situation);
    double worst = 0;  // as far as there
    for (std::size_t i = 0; i < bare_distances_km.size() && bare_distances_km[i] <= 1.001 * km; ++i) {
        const std::optional<double> error = skies.bare[i].in(scene);
        if (!error) return {};
        worst = std::max(worst, *error * bare_share(extinction, bare_distances_km[i]));
        if (bare_distances_km[i] >= 0.999 * km) return needs.geometry ? std::optional(worst) : std::nullopt;
    }
    return {};
}

/// Of the settings that were measured in this scene, within so much of the tolerance; with the air before geometry, and without
/// it where that was measured to be within as much. Costs as measured in its air; as foretold for it where they were not.
inline double cheapest_that_meets(const PlanRequirements& needs, const Predictor& predictor, std::size_t scene, double share) {
    double cheapest = std::numeric_limits<double>::infinity();
    const MeasuredSkies& skies = predictor.skies();
    const double limit = share * *needs.tolerance;
    const auto meets = [&](const MeasuredSetting& setting, AirBefore air) {
        const std::optional<double> worst = measured_worst(judged_by(needs, air), setting, scene);
        return worst && *worst <= limit;
    };
    const std::optional<double> bare = measured_bare(needs, skies, scene);
    for (const MeasuredSetting& setting : skies.settings) {
        const bool drawn = meets(setting, air_asked_for(needs));
        const bool left_out = bare && *bare <= limit && meets(setting, AirBefore::left_out);
        if (!drawn && !left_out) continue;
        MeasuredCost cost = setting.by_air[skies.scenes[scene].air];
        if (cost.air_mib == 0) {
            const Prepared prepared = prepare(setting.setting, needs.air).value();
            const auto foretold =
                predictor.cost(setting, skies.scenes[scene].situation, table_work(*prepared.model, prepared.air));
            if (!foretold) continue;  // no plan takes it
            cost = *foretold;
        }
        if (drawn) cheapest = std::min(cheapest, cost_of(needs, cost).cost.charged_ms);
        if (left_out) cheapest = std::min(cheapest, cost_of(needs, cost, AirBefore::left_out).cost.charged_ms);
    }
    return cheapest;
}

struct Planned {
    std::size_t planned = 0, refused = 0;
    std::size_t of_air = 0;  ///< Plans with geometry whose choice to draw the air before it, or not, was measured.
};

/// The air before geometry is left out just where that was measured to be within the tolerance; says whether it was measured.
inline bool check_air_before(const PlanRequirements& needs, const MeasuredSkies& skies, std::size_t scene, const Plan& found) {
    const bool drawn = found.view.aerial_perspective;
    if (!needs.geometry || needs.geometry_range_m > 1001 * bare_distances_km.back()) {
        CHECK(drawn == needs.geometry);
        return false;
    }
    const std::optional<double> bare = measured_bare(needs, skies, scene);
    if (!bare) return false;
    // Errors are kept in thousandths of their logarithm: what is right on the tolerance may fall on either side.
    if (*bare > 1.01 * *needs.tolerance) CHECK(drawn);
    if (*bare < 0.99 * *needs.tolerance) CHECK_FALSE(drawn);
    return true;
}

/// `needs` for a scene of that air: for every tolerance from half a percent to 20 % the plan is the cheapest measured setting
/// that meets it, or within 15 % of that cost; without the air before geometry where that does.
inline Planned check_plans_of(PlanRequirements needs, const Predictor& predictor, std::size_t scene) {
    const MeasuredSkies& skies = predictor.skies();
    const MeasuredScene& at = skies.scenes[scene];
    needs.sun_elevation_deg = {at.sun_elevation_deg, at.sun_elevation_deg};
    needs.altitude_m = {at.altitude_m, at.altitude_m};
    Planned count;
    for (const double tolerance : std::array{0.005, 0.0075, 0.01, 0.015, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2}) {
        needs.tolerance = tolerance;
        const Plan found = plan(needs);
        INFO(at.id, " at ", tolerance, ", geometry up to ", needs.geometry ? needs.geometry_range_m : 0.0,
             needs.light ? " m, light: " : " m: ", found.setting.id());
        CHECK(found.distance < 0.01);
        const bool air_is_known = check_air_before(needs, skies, scene, found);
        count.of_air += air_is_known ? 1 : 0;
        const double cheapest = cheapest_that_meets(needs, predictor, scene, 0.99);
        if (std::isfinite(cheapest)) CHECK(found.tolerable);
        ++(found.tolerable ? count.planned : count.refused);
        if (!found.tolerable) continue;
        CHECK(std::max(found.error.p95, found.error.light) <= 1.01 * tolerance);
        CHECK(found.cost.charged_ms <= 1.15 * cheapest);
        // Unless it takes what was measured elsewhere, and is foretold to be good enough here.
        const bool left_out = needs.geometry && !found.view.aerial_perspective;
        const AirBefore air = left_out ? AirBefore::left_out : air_asked_for(needs);
        const auto chosen = std::ranges::find(skies.settings, found.setting, &MeasuredSetting::setting);
        if (measured_worst(judged_by(needs, air), *chosen, scene) && (!left_out || air_is_known))
            CHECK(found.cost.charged_ms >= 0.999 * cheapest_that_meets(needs, predictor, scene, 1.01));
    }
    return count;
}

}  // namespace aureole::detail
