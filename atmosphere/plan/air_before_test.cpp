// Geometry: errors by its distance, and the air before it left out where that changes less than the tolerance.
#include "plan/candidates.h"

#include <aureole/plan.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace aureole;
using namespace aureole::detail;

namespace {

PlanRequirements with_geometry(double range_m, double tolerance) {
    PlanRequirements needs;
    needs.air = presets::earth();
    needs.sun_elevation_deg = {25, 25};
    needs.geometry = true;
    needs.geometry_range_m = range_m;
    needs.tolerance = tolerance;
    return needs;
}

/// The same everywhere, and certain.
MeasuredError everywhere(const MeasuredSkies& skies, double error) {
    return {0, std::vector(skies.scenes.size(), MeasuredError::pack(error))};
}

/// Without the air before it, geometry in clear Earth's errs by `error_of` the depth of the air up to it, everywhere.
template <class ErrorOf>
void set_bare(MeasuredSkies& skies, const ErrorOf& error_of) {
    const AirCoordinates air(presets::earth());
    const double extinction = extinction_per_m(densest_extinction_per_m(presets::earth()), air.at(25, 2));
    for (std::size_t i = 0; i < skies.bare.size(); ++i) {
        const double km = bare_distances_km[i];
        skies.bare[i] = everywhere(skies, error_of(1000 * extinction * km) / bare_share(extinction, km));
    }
}

/// What ships, but for geometry: without the air before it `bare` times the share of light that does not come through is
/// missing; with it errors are `near` and `far`.
MeasuredSkies skies_with(double bare, double near, double far) {
    MeasuredSkies skies = measured_in_rgb();
    for (MeasuredError& error : skies.bare) error = everywhere(skies, bare);
    for (MeasuredSetting& setting : skies.settings) {
        setting.aerial_near_p95 = everywhere(skies, near);
        setting.aerial_far_p95 = everywhere(skies, far);
        for (MeasuredCost& cost : setting.by_air) cost.composite_bare_ms = 0.9 * cost.composite_geometry_ms;
    }
    return skies;
}

Outlook seen(const PlanRequirements& needs, const MeasuredSkies& skies, bool keep_air = false) {
    return outlook(needs, Predictor(skies), situations_of(needs, skies), keep_air);
}

const PlanChoice& choice_of(const Plan& plan, const std::string& what) {
    const auto found = std::ranges::find(plan.choices, what, &PlanChoice::what);
    REQUIRE(found != plan.choices.end());
    return *found;
}

}  // namespace

TEST_CASE("plan: geometry is judged by the distances that there are") {
    const MeasuredSkies skies = skies_with(100, 0.3, 3);
    const auto bounds = [&](double range_m) { return seen(with_geometry(range_m, 0.02), skies).candidates; };
    const auto near = bounds(9e3), far = bounds(11e3);
    PlanRequirements none = with_geometry(9e3, 0.02);
    none.geometry = false;
    const auto sky = seen(none, skies).candidates;
    for (std::size_t i = 0; i < sky.size(); ++i) {
        if (!sky[i].excluded.empty()) continue;
        CHECK(near[i].error.bound == doctest::Approx(std::max(sky[i].error.bound, 0.3)).epsilon(2e-3).scale(1e-300));
        CHECK(far[i].error.bound == doctest::Approx(std::max(sky[i].error.bound, 3.0)).epsilon(2e-3).scale(1e-300));
        CHECK(near[i].cost.frame_ms == far[i].cost.frame_ms);
    }
    // Tables that do not tell distances apart have one error for all.
    MeasuredSkies old = skies;
    for (MeasuredSetting& setting : old.settings) {
        setting.aerial_near_p95 = setting.aerial_far_p95 = {};
        setting.aerial_p95 = everywhere(old, 7);
    }
    for (const double range_m : {9e3, 11e3})
        for (const PlanCandidate& one : seen(with_geometry(range_m, 0.02), old).candidates)
            if (one.excluded.empty()) CHECK(one.error.bound >= 0.998 * 7);
}

namespace {

void check_left_out(const Outlook& found, const Outlook& kept) {
    for (std::size_t i = 0; i < found.candidates.size(); ++i) {
        const PlanCandidate &one = found.candidates[i], &other = kept.candidates[i];
        if (!one.excluded.empty()) continue;
        CHECK(one.cost.charged_ms <= other.cost.charged_ms);
        CHECK(one.cost.mebibytes <= other.cost.mebibytes);
        if (found.air == AirBefore::drawn) continue;
        CHECK(one.error.bound >= found.bare->bound);
        CHECK(found.bound_otherwise[i] == other.error.bound);
        CHECK(kept.bound_otherwise[i] == one.error.bound);
        CHECK(one.cost.frame_ms < other.cost.frame_ms);
    }
}

/// Distances in km: between those that are known, at them, nearer and farther than all.
constexpr std::array asked_km{0.003, 0.01, 0.02, 0.0316, 0.1, 0.25, 0.6, 1.0, 1.3, 2.0, 5.0, 20.0, 31.6, 40.0, 200.0};

}  // namespace

TEST_CASE("plan: the air before geometry is left out just where that changes no more than the tolerance") {
    const double times = 2, tolerance = 0.05;
    const MeasuredSkies skies = skies_with(times, 1e-3, 1e-3);
    for (const double km : asked_km) {
        CAPTURE(km);
        PlanRequirements needs = with_geometry(1000 * km, tolerance);
        const Outlook found = seen(needs, skies), kept = seen(needs, skies, true);
        REQUIRE(found.bare.has_value() == (km <= bare_distances_km.back()));
        CHECK((found.air == AirBefore::left_out) == (found.bare && found.bare->bound <= tolerance));
        CHECK(kept.air == AirBefore::drawn);
        check_left_out(found, kept);
        needs.shadows = true;  // they are seen in it
        CHECK(seen(needs, skies).air == AirBefore::drawn);
        needs.shadows = false;
        needs.tolerance.reset();
        needs.budget_ms = 1;
        CHECK(seen(needs, skies).air == AirBefore::drawn);
        needs.geometry = false;
        CHECK(seen(needs, skies).air == AirBefore::nothing);
    }
    MeasuredSkies unknown = skies;
    unknown.bare = {};
    const Outlook found = seen(with_geometry(1, 0.5), unknown);
    CHECK(found.air == AirBefore::drawn);
    CHECK_FALSE(found.bare);
}

TEST_CASE("plan: between known distances what geometry errs by is bounded, be the air brighter or darker than it") {
    MeasuredSkies skies = skies_with(1, 1e-3, 1e-3);
    const AirCoordinates air(presets::earth());
    const double per_km = 1000 * extinction_per_m(densest_extinction_per_m(presets::earth()), air.at(25, 2));
    double (*error_of)(double depth) = nullptr;
    // Air that is far brighter than geometry, as bright again as it, and black: the last grows faster than the distance.
    SUBCASE("brighter") {
        error_of = [](double depth) { return -std::expm1(-depth) / (0.1 - std::expm1(-depth)); };
    }
    SUBCASE("of the share that does not come through") {
        error_of = [](double depth) { return -std::expm1(-depth); };
    }
    SUBCASE("black") {
        error_of = [](double depth) { return std::expm1(depth); };
    }
    set_bare(skies, error_of);
    constexpr double packed = 1.001;  // errors are kept in thousandths of their logarithm
    for (const double km : asked_km) {
        CAPTURE(km);
        if (km > bare_distances_km.back()) continue;
        const PredictedError found = seen(with_geometry(1000 * km, 0.05), skies).bare.value();
        const double truth = error_of(per_km * km);
        CHECK(found.bound >= truth / packed);
        const double next_km = *std::ranges::lower_bound(bare_distances_km, km);
        CHECK(found.bound == doctest::Approx(error_of(per_km * next_km)).epsilon(packed - 1).scale(1e-300));
        // Over logarithms the slopes of all three change by less than 0.3 from one distance to the next: a chord is off by
        // no more than 0.3 ln(3.2) / 8.
        CHECK(found.likely == doctest::Approx(truth).epsilon(0.05).scale(1e-300));
        CHECK(found.likely <= packed * found.bound);
    }
}

TEST_CASE("plan: in tables that do not know what a composite without air takes, leaving it out saves its tables alone") {
    MeasuredSkies skies = skies_with(1e-3, 0.01, 0.01);
    for (MeasuredSetting& setting : skies.settings)
        for (MeasuredCost& cost : setting.by_air) cost.composite_bare_ms = 0;
    const PlanRequirements needs = with_geometry(100, 0.1);
    const Predictor predictor(skies);
    const Situation place = AirCoordinates(needs.air).at(25, 2);
    for (const MeasuredSetting& setting : skies.settings) {
        const std::optional<MeasuredCost> cost = predictor.cost(setting, place, {});
        if (!cost) continue;
        CHECK(cost->composite_bare_ms == 0);
        const CostParts drawn = cost_of(needs, *cost), bare = cost_of(needs, *cost, AirBefore::left_out);
        CHECK(drawn.cost.frame_ms - bare.cost.frame_ms ==
              doctest::Approx(drawn.aerial_perspective_ms).epsilon(1e-9).scale(drawn.cost.frame_ms));
    }
}

TEST_CASE("plan: what is far off at one hour keeps the air for the whole range") {
    MeasuredSkies skies = skies_with(1e-3, 1e-3, 1e-3);
    for (std::size_t i = 0; i < skies.scenes.size(); ++i)
        if (skies.scenes[i].sun_elevation_deg < 2)
            for (MeasuredError& error : skies.bare) error.by_scene[i] = MeasuredError::pack(100);
    PlanRequirements needs = with_geometry(5e3, 0.05);
    CHECK(seen(needs, skies).air == AirBefore::left_out);
    needs.sun_elevation_deg = {1, 25};
    CHECK(seen(needs, skies).air == AirBefore::drawn);
}

TEST_CASE("plan: errors of geometry without the air before it grow with its distance") {
    const Predictor predictor(measured_in_rgb());
    for (const char* name : {"earth", "hazy_earth", "mars"}) {
        const AtmosphereParameters air = presets::by_name(name);
        const double densest = densest_extinction_per_m(air);
        Predictor::Here here = predictor.at(AirCoordinates(air).at(20, 2));
        REQUIRE(here.bare(1, densest));
        PredictedError before;
        for (double km = 1e-4; km < bare_distances_km.back(); km *= 1.3) {
            const PredictedError now = here.bare(1000 * km, densest).value();
            CHECK(now.likely >= before.likely);
            CHECK(now.bound >= before.bound);
            CHECK(now.bound >= now.likely);
            before = now;
        }
    }
}

TEST_CASE("plan: the next distance that is known counts, near the ground and high up, and beyond none is") {
    const Predictor predictor(measured_in_rgb());
    const AtmosphereParameters air = presets::earth();
    const double densest = densest_extinction_per_m(air);
    const auto bound = [&](double altitude_m, double km) -> std::optional<double> {
        const auto found = predictor.at(AirCoordinates(air).at(20, altitude_m)).bare(1000 * km, densest);
        return found ? std::optional(found->bound) : std::nullopt;
    };
    for (const double altitude_m : {2.0, 10e3}) {
        CAPTURE(altitude_m);
        CHECK(bound(altitude_m, 4).value() == bound(altitude_m, 10).value());
        CHECK(bound(altitude_m, 31.6));
        CHECK_FALSE(bound(altitude_m, 32));
    }
    CHECK_FALSE(bound(4e5, 0.01));
}

TEST_CASE("plan: a plan without the air before geometry has no froxels, and says what it errs by and saves") {
    const PlanRequirements needs = with_geometry(1, 0.3);
    const Plan found = plan(needs);
    REQUIRE_FALSE(found.view.aerial_perspective);
    const PlanChoice& choice = choice_of(found, "aerial perspective");
    CHECK(choice.chosen == "left out");
    CHECK(choice.reason.find("geometry up to 0.00100 km away is off by") != std::string::npos);
    CHECK(choice.reason.find("within the tolerance of 30 %: saves") != std::string::npos);
    CHECK(choice.reason.find("albedo 0.19: what is darker errs by more") != std::string::npos);
    CHECK(choice.reason.find("view.aerial_perspective = true keeps") != std::string::npos);
    CHECK(choice.cost_otherwise_ms.value() >= 0);
    CHECK(choice.error_otherwise);
    CHECK(std::ranges::find(found.choices, "froxels", &PlanChoice::what) == found.choices.end());
    CHECK(std::ranges::none_of(found.warnings, [](const auto& w) { return w.find("is FAR from") != std::string::npos; }));
    const Plan far = plan(with_geometry(3e4, 1e-3));
    CHECK(far.view.aerial_perspective);
    CHECK(choice_of(far, "aerial perspective").reason.find("away would be off by") != std::string::npos);
    CHECK(choice_of(far, "aerial perspective").reason.find("more than 0.10 %") != std::string::npos);
    const Plan farther = plan(with_geometry(9e4, 0.3));
    CHECK(farther.view.aerial_perspective);
    CHECK(choice_of(farther, "aerial perspective").reason.find("is not known beyond 31.6 km") != std::string::npos);
}

TEST_CASE("plan: shadows in the air are bounded by the light that was scattered more than once") {
    MeasuredSkies skies = skies_with(1, 0.01, 0.01);
    PlanRequirements needs = with_geometry(1e4, 0.2);
    const auto bound = [&] { return shadows_bound(needs, Predictor(skies), situations_of(needs, skies)); };
    const auto single = std::ranges::find_if(skies.settings, [](const MeasuredSetting& one) {
        return one.setting.without == std::vector<std::string>{"multiple scattering"};
    });
    REQUIRE(single != skies.settings.end());
    single->sky_p95 = everywhere(skies, 0.2);
    const double sky = bound().value();
    CHECK(sky > 0.2);
    CHECK(sky < 0.25);  // and the march
    single->aerial_near_p95 = single->aerial_far_p95 = everywhere(skies, 0.4);
    CHECK(bound().value() == doctest::Approx(sky + 0.2).epsilon(1e-3).scale(1));
    single->sky_p95 = everywhere(skies, 3);
    CHECK(bound() == 1.0);  // there is no more light than all
    std::erase_if(skies.settings, [](const MeasuredSetting& one) { return one.setting.leaves_out("multiple scattering"); });
    CHECK_FALSE(bound());

    const Plan bare = plan(needs);
    CHECK_FALSE(bare.shadows_bound);
    needs.shadows = true;
    const Plan shadowed = plan(needs);
    REQUIRE(shadowed.shadows_bound);
    CHECK(shadowed.text().find("error of shadows in the air: below") != std::string::npos);
    CHECK(shadowed.text().find("for 95 of 100 directions in 95 cases of 100") != std::string::npos);
    CHECK(choice_of(shadowed, "shadows").reason.find("95 of 100 directions err by at most") != std::string::npos);
}
