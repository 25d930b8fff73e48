#include "common/rejects.h"
#include "plan/candidates.h"
#include "plan/choices.h"

#include <aureole/plan.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace aureole;
using namespace aureole::detail;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

PlanRequirements earth(double tolerance) {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {30, 30};
    needs.tolerance = tolerance;
    return needs;
}

const PlanChoice* find(const Plan& plan, const std::string& what) {
    const auto found = std::ranges::find(plan.choices, what, &PlanChoice::what);
    return found == plan.choices.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("plan: bad requirements are refused by name") {
    using Needs = PlanRequirements;
    const std::vector<std::pair<std::string, std::function<void(Needs&)>>> mistakes{
        {"sun_elevation_deg.least",
         [](Needs& n) {
             n.sun_elevation_deg = {-91, 0};
         }},
        {"sun_elevation_deg.most",
         [](Needs& n) {
             n.sun_elevation_deg = {10, 9};
         }},
        {"altitude_m.least",
         [](Needs& n) {
             n.altitude_m = {-2e4, 0};
         }},
        {"altitude_m.most",
         [](Needs& n) {
             n.altitude_m = {0, not_a_number};
         }},
        {"geometry_range_m", [](Needs& n) { n.geometry_range_m = 0; }},
        {"suns", [](Needs& n) { n.suns = 5; }},
        {"views", [](Needs& n) { n.views = 0; }},
        {"width", [](Needs& n) { n.width = 0; }},
        {"height", [](Needs& n) { n.height = 70000; }},
        {"rebuilds_per_frame", [](Needs& n) { n.rebuilds_per_frame = 1.1; }},
        {"speed.composite", [](Needs& n) { n.speed.composite = 0; }},
        {"speed.tables", [](Needs& n) { n.speed.tables = not_a_number; }},
        {"tolerance", [](Needs& n) { n.tolerance = 0; }},
        {"budget_ms", [](Needs& n) { n.budget_ms = -1; }},
        {"budget_mib", [](Needs& n) { n.budget_mib = not_a_number; }},
        {"tolerance", [](Needs& n) { n.tolerance.reset(); }},
        {"planet.bottom_radius_m", [](Needs& n) { n.air.planet.bottom_radius_m = 0; }},
    };
    for (const auto& [field, mistake] : mistakes) {
        PlanRequirements needs = earth(0.02);
        mistake(needs);
        CHECK(rejected_field([&] { (void)plan(needs); }) == field);
    }
    CHECK(rejected_field([] { (void)calibrated({0, 1}); }) == "composite_ms");
    CHECK(rejected_field([] { (void)calibrated({1, not_a_number}); }) == "tables_ms");
}

TEST_CASE(
    "plan: where colours are those of wavelengths, settings in wavelengths are taken, and three of red, green and blue err "
    "more") {
    PlanRequirements needs = earth(0.05);
    needs.wavelengths = true;
    needs.sun_elevation_deg = {-4, 10};
    const Plan found = plan(needs);
    for (const PlanCandidate& one : found.candidates) CHECK(one.setting.spectral != "rgb");
    REQUIRE(find(found, "wavelengths"));
    const auto error_of = [&](const Setting& setting) {
        return std::ranges::find(found.candidates, setting, &PlanCandidate::setting)->error.p95;
    };
    CHECK(error_of({"aureole", "default", "4", {}}) < 0.7 * error_of({"aureole", "default", "4", {"wavelengths"}}));
    needs.air = presets::mars();
    const Plan strange = plan(needs);  // never measured in wavelengths
    CHECK(strange.distance > 1);
    CHECK(strange.text().find("FAR from all") != std::string::npos);
    CHECK(found.distance < 1);
    CHECK(strange.error.bound / strange.error.p95 > 1.2 * found.error.bound / found.error.p95);
}

TEST_CASE("plan: what it returns can be drawn as it is, and says what it does without") {
    PlanRequirements needs = earth(0.03);
    const Plan bare = plan(needs);
    REQUIRE(bare.tolerable);
    CHECK(bare.error.bound <= 0.03);
    CHECK(bare.error.p95 <= bare.error.bound);
    CHECK(bare.model);
    CHECK_FALSE(bare.view.aerial_perspective);
    CHECK(bare.view.light);
    REQUIRE(find(bare, "aerial perspective"));
    CHECK(find(bare, "aerial perspective")->chosen == "left out");
    REQUIRE(find(bare, "term rayleigh"));
    for (const PlanCandidate& one : bare.candidates) {  // what a setting leaves out is not in its air, and all else is
        const std::optional<Prepared> prepared = prepare(one.setting, needs.air);
        CHECK(prepared.has_value() == one.excluded.empty());
        if (!prepared) continue;
        if (one.setting == bare.setting) CHECK(bare.air == prepared->air);
        for (const DensityTerm& term : needs.air.terms)
            CHECK((std::ranges::count(prepared->air.terms, term.name, &DensityTerm::name) == 0) ==
                  one.setting.leaves_out(term.name));
    }

    needs.geometry = true;
    needs.geometry_range_m = 12345;
    needs.light = false;
    needs.suns = 2;
    const Plan full = plan(needs);
    CHECK(full.view.aerial_perspective);
    CHECK(full.view.aerial_perspective_distance_m == 12345);
    CHECK_FALSE(full.view.light);
    CHECK(full.view.max_suns == 2);
    CHECK(find(full, "aerial perspective")->chosen == "recorded");
    CHECK(find(full, "light")->chosen == "left out");
    for (const Plan* each : {&bare, &full}) {
        const std::string text = each->text();
        for (const PlanChoice& choice : each->choices)
            CHECK(text.find(choice.what + ": " + choice.chosen) != std::string::npos);
        CHECK(std::ranges::is_sorted(each->candidates, {}, [](const PlanCandidate& one) {
            return one.excluded.empty() ? one.cost.charged_ms : std::numeric_limits<double>::infinity();
        }));
    }
}

TEST_CASE("plan: looser tolerances cost no more, tighter budgets err no less") {
    double before = std::numeric_limits<double>::infinity();
    for (const double tolerance : {0.02, 0.05, 0.1, 0.2, 0.5}) {
        const Plan found = plan(earth(tolerance));
        if (!found.tolerable) continue;
        CHECK(found.cost.charged_ms <= 1.1 * before);  // what costs the same within a tenth is the same
        before = found.cost.charged_ms;
    }
    PlanRequirements needs = earth(0.01);
    needs.tolerance.reset();
    double error = 0;
    needs.budget_ms = 1e6;
    const std::vector<PlanCandidate> all = plan(needs).candidates;
    std::vector<double> budgets;
    for (const PlanCandidate& one : all)
        if (one.excluded.empty()) budgets.insert(budgets.begin(), one.cost.charged_ms);
    REQUIRE(budgets.size() > 5);
    for (const double budget : budgets) {
        needs.budget_ms = budget;
        const Plan found = plan(needs);
        REQUIRE(found.tolerable);
        CHECK(found.cost.charged_ms <= budget);
        CHECK(found.error.bound >= error / 1.1);  // what is as accurate within a tenth is the same
        error = std::max(error, found.error.bound);
    }
    needs.budget_ms = 1e-3;
    CHECK_FALSE(plan(needs).tolerable);
    CHECK(plan(needs).text().find("does NOT meet") != std::string::npos);
}

TEST_CASE("plan: what the air, the views and the device are like counts") {
    const Plan once = plan(earth(0.05));
    PlanRequirements needs = earth(0.05);
    needs.views = 2;
    const auto cost_of = [](const Plan& plan, const Setting& setting) {
        return std::ranges::find(plan.candidates, setting, &PlanCandidate::setting)->cost;
    };
    CHECK(cost_of(plan(needs), once.setting).mebibytes > once.cost.mebibytes);
    CHECK(cost_of(plan(needs), once.setting).frame_ms == doctest::Approx(2 * once.cost.frame_ms).epsilon(1e-9).scale(1e-300));
    needs = earth(0.05);
    needs.speed = {0.01, 0.01};
    CHECK(cost_of(plan(needs), once.setting).frame_ms == doctest::Approx(once.cost.frame_ms / 100).epsilon(1e-9).scale(1e-300));
    // Where tables are made anew each frame, their cost is charged.
    needs = earth(0.05);
    needs.rebuilds_per_frame = 1;
    const Plan changing = plan(needs);
    CHECK(changing.cost.charged_ms ==
          doctest::Approx(changing.cost.frame_ms + changing.cost.rebuild_ms).epsilon(1e-9).scale(1e-300));
    CHECK(changing.setting.model != "bruneton");
    // A day that ends in twilight is harder than its noon.
    needs = earth(0.05);
    needs.sun_elevation_deg = {-6, 60};
    const Plan evening = plan(needs);
    for (const PlanCandidate& one : evening.candidates)
        if (one.setting == once.setting) CHECK(one.error.bound >= once.error.bound);
    // Mars has no ozone to leave out.
    needs.air = presets::mars();
    for (const PlanCandidate& one : plan(needs).candidates)
        if (one.setting.leaves_out("ozone")) CHECK_FALSE(one.excluded.empty());
    // Fog has no shadows.
    needs = earth(0.05);
    needs.shadows = true;
    for (const PlanCandidate& one : plan(needs).candidates)
        if (one.setting.model == "fog") CHECK(one.excluded == "has no shadows in the air");
}

TEST_CASE("plan: far from all that was measured it says so, and its bound is wide") {
    PlanRequirements needs = earth(0.05);
    const Plan known = plan(needs);
    CHECK(known.distance < 1);
    needs.air.planet = {1e3, 10e3, Rgb(1)};
    for (DensityTerm& term : needs.air.terms) {
        term.profile = ExponentialProfile{5000};
        term.scattering_per_m *= 1000;
    }
    const Plan strange = plan(needs);
    CHECK(strange.distance > 1);
    CHECK(strange.text().find("FAR from all") != std::string::npos);
    CHECK(known.text().find("FAR from all") == std::string::npos);
    CHECK(strange.error.bound / strange.error.p95 > known.error.bound / known.error.p95);
}

TEST_CASE("plan: it warns of what its figures do not cover, and says whose speed its costs are of") {
    const auto warned = [](const PlanRequirements& needs, const std::string& part) {
        const Plan found = plan(needs);
        const bool told =
            std::ranges::any_of(found.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
        CHECK(told == (found.text().find(part) != std::string::npos));
        return told;
    };
    PlanRequirements needs = earth(0.05);
    CHECK(plan(needs).warnings.empty());
    CHECK(plan(needs).text().find("not calibrated for another device") != std::string::npos);
    needs.tolerance = 1e-3;  // so little that the air before geometry is never left out
    for (const auto& [range_m, outside] : {std::pair{1e3, false}, {1e5, false}, {999.0, true}, {1.01e5, true}}) {
        needs.geometry_range_m = range_m;
        needs.geometry = false;
        CHECK_FALSE(warned(needs, "away is FAR from what was measured"));
        needs.geometry = true;
        CHECK(warned(needs, "away is FAR from what was measured") == outside);
    }
    needs = earth(0.05);
    needs.budget_mib = 100;
    CHECK_FALSE(warned(needs, "budget in milliseconds"));
    needs.budget_ms = 1000;
    CHECK(warned(needs, "budget in milliseconds"));
    needs.speed = {0.5, 0.25};
    CHECK_FALSE(warned(needs, "budget in milliseconds"));
    CHECK(plan(needs).speed == needs.speed);
    CHECK(plan(needs).text().find("calibrated: composites take 0.50 times, tables 0.25 times as long") != std::string::npos);
}

TEST_CASE("plan: where nothing can be taken every setting's reason is told") {
    const std::string text = exclusions({{{"fog", "low", "rgb", {}}, {}, {}, false, "has no shadows in the air"},
                                         {{"aureole", "low", "rgb", {}}, {}, {}, true, {}},
                                         {{"fog", "high", "rgb", {}}, {}, {}, false, "has no shadows in the air"},
                                         {{"single", "high", "rgb", {}}, {}, {}, false, "was not measured"}});
    CHECK(text == "has no shadows in the air (fog low, fog high); was not measured (single high)");
    CHECK(exclusions({}) == "nothing was measured");
}

TEST_CASE("plan: budgets of memory count every view, and froxels only where there is geometry") {
    PlanRequirements needs = earth(0.05);
    const Plan bare = plan(needs);
    needs.geometry = true;
    const auto memory_of = [](const Plan& plan, const Setting& setting) {
        return std::ranges::find(plan.candidates, setting, &PlanCandidate::setting)->cost.mebibytes;
    };
    const Setting ours = speed_setting();
    const double once = memory_of(plan(needs), ours);
    CHECK(once > memory_of(bare, ours));
    needs.views = 2;
    const double one_view = memory_of(plan(needs), ours) - once;
    CHECK(one_view > 0);
    needs.views = 3;
    needs.suns = 4;
    CHECK(memory_of(plan(needs), ours) == doctest::Approx(once + 11 * one_view).epsilon(1e-9).scale(1e-300));
    needs = earth(0.05);
    needs.tolerance.reset();
    needs.budget_mib = 1.01 * bare.cost.mebibytes;
    const Plan within = plan(needs);
    CHECK(within.tolerable);
    CHECK(within.cost.mebibytes <= *needs.budget_mib);
    needs.budget_mib = 1e-9;
    CHECK_FALSE(plan(needs).tolerable);
}

TEST_CASE("plan: its own machine is calibrated to 1") {
    const MeasuredSkies& skies = measured_in_rgb();
    const auto air = static_cast<std::size_t>(std::ranges::find(skies.airs, "earth") - skies.airs.begin());
    REQUIRE(air < skies.airs.size());
    const auto setting = std::ranges::find(skies.settings, speed_setting(), &MeasuredSetting::setting);
    REQUIRE(setting != skies.settings.end());
    const MeasuredCost& cost = setting->by_air[air];
    const DeviceSpeed speed =
        calibrated({cost.composite_ms, cost.view_ms + cost.aerial_perspective_ms + cost.light_ms + cost.rebuild_ms});
    CHECK(speed.composite == doctest::Approx(1).epsilon(1e-9).scale(1e-300));
    CHECK(speed.tables == doctest::Approx(1).epsilon(1e-9).scale(1e-300));
    CHECK(calibrated({cost.composite_ms / 50, 1}).composite == doctest::Approx(0.02).epsilon(1e-9).scale(1e-300));
}
