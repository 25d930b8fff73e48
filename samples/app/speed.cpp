#include "app/speed.h"

#include "app/pass_costs.h"
#include "plan/candidates.h"

#include <aureole/presets.h>

#include <algorithm>
#include <cmath>

namespace aureole::app {

DeviceSpeed measure_speed(Backend& backend, double seconds) {
    Prepared prepared = prepare(speed_setting(), presets::earth()).value();
    const CostSubject subject{"calibration", std::move(prepared.air), std::move(prepared.model)};
    PassCostOptions options;
    options.geometry = options.counts = false;
    const auto run = [&](std::uint32_t frames, std::uint32_t warm_up) {
        options.frames = frames;
        options.warm_up = warm_up;
        return pass_costs(backend, {&subject, 1}, options, [] {}).at(0);
    };
    const PassCosts first = run(1, 1);
    const double round_ms = std::max(first.rebuild.median + first.pass("composite").milliseconds.median, 1e-3);
    const PassCosts found =
        run(static_cast<std::uint32_t>(std::clamp(std::floor(1000 * seconds / round_ms) - 2, 3.0, 1000.0)), 1);
    return calibrated({found.pass("composite").milliseconds.median, found.rebuild.median});
}

PlanCost measure_plan(Backend& backend, const PlanRequirements& requirements, const Plan& plan, std::uint32_t rounds) {
    const CostSubject subject{"the plan", plan.air, plan.model};
    PassCostOptions options;
    options.width = requirements.width;
    options.height = requirements.height;
    options.frames = rounds;
    options.geometry = requirements.geometry || requirements.shadows;
    const bool bare = options.geometry && !plan.view.aerial_perspective;
    options.features = requirements.suns > 1 || requirements.shadows || bare;
    options.counts = false;
    const PassCosts found = pass_costs(backend, {&subject, 1}, options, [] {}).at(0);
    const auto median = [&](const char* pass) { return found.pass(pass).milliseconds.median; };
    detail::MeasuredCost cost;
    for (std::size_t i = 0; i < found.air_passes; ++i) cost.rebuild_ms += found.passes[i].milliseconds.median;
    for (std::size_t i = found.air_passes; i < found.air_passes + found.view_passes; ++i) {
        const PassCost& pass = found.passes[i];
        (pass.name == "aerial_perspective" ? cost.aerial_perspective_ms
         : pass.name == "light"            ? cost.light_ms
                                           : cost.view_ms) += pass.milliseconds.median;
    }
    cost.composite_ms = median("composite");
    if (options.geometry) cost.composite_geometry_ms = median("composite_geometry");
    if (bare) cost.composite_bare_ms = median("composite_bare");
    if (requirements.suns > 1) cost.composite_sun_ms = std::max(median("composite_two_suns") - cost.composite_ms, 0.0);
    if (requirements.shadows) {
        cost.shadows_ms = median("shadows");
        cost.composite_shadows_ms = std::max(median("composite_shadows") - cost.composite_geometry_ms, 0.0);
    }
    // These are already of the plan's own pixels, on the device at hand.
    PlanRequirements as_measured = requirements;
    as_measured.width = detail::measured_width;
    as_measured.height = detail::measured_height;
    as_measured.speed = {};
    PlanCost measured =
        detail::cost_of(as_measured, cost, bare ? detail::AirBefore::left_out : detail::air_asked_for(requirements)).cost;
    measured.mebibytes = 0;
    return measured;
}

}  // namespace aureole::app
