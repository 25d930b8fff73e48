// Planned sky: where sun and camera are, from night to day and from the ground to space.
#include "planned_sky/place.h"

#include "plan/axes.h"
#include "plan/keep.h"
#include "planned_sky/test_sky.h"

#include "common/rejects.h"

#include <limits>
#include <set>

using namespace aureole;
using namespace aureole::passes;
using namespace aureole::detail;

namespace {

constexpr double margin = 0.1;

Sun dim(Sun sun, double factor) {
    sun.irradiance *= factor;
    return sun;
}

Place at(double sun_deg, double altitude_m = 2) {
    const Planet planet = presets::earth().planet;
    return {sun_axis(sun_deg), sun_axis(sun_deg), altitude_axis(altitude_m, planet)};
}

Place seen(const std::vector<Sun>& suns) {
    const Planet planet = presets::earth().planet;
    return place_of(planet, camera_at(planet, 2), suns, at(33));
}

}  // namespace

TEST_CASE("planned sky: every sun that lights the sky has its place, however faint beside another") {
    const auto near_to = [](double deg) { return doctest::Approx(sun_axis(deg)).epsilon(1e-6).scale(1); };
    const Place moonlit = seen({sun_at(-30), dim(sun_at(40), 1e-6)});
    CHECK(moonlit.lowest_sun == near_to(40));
    CHECK(moonlit.highest_sun == near_to(40));
    const Place both = seen({sun_at(40), dim(sun_at(-10), 1e-6)});
    CHECK(both.lowest_sun == near_to(-10));
    CHECK(both.highest_sun == near_to(40));
    CHECK(seen({sun_at(40), dim(sun_at(-10), 0)}).lowest_sun == near_to(40));  // it is out
    for (const double below : {-19.0, -30.0, -90.0}) {
        CHECK(seen({sun_at(below)}).lowest_sun == near_to(night_deg));
        CHECK(seen({sun_at(below)}).highest_sun == near_to(night_deg));
    }
    CHECK(seen({}).highest_sun == near_to(33));
}

TEST_CASE("planned sky: what a plan is made for is around the place, within the requirements or at the place itself") {
    PlanRequirements needs = day_and_dusk(0.1);  // -6 to 70 degrees, 2 m
    Place both = at(40);
    both.lowest_sun = sun_axis(-5.9);
    PlanRequirements part = around(needs, both, margin);
    CHECK(part.sun_elevation_deg.least == -6);
    CHECK(part.sun_elevation_deg.most == doctest::Approx(elevation_of(sun_axis(40) + margin)).epsilon(1e-9).scale(1e-300));
    CHECK(part.altitude_m == needs.altitude_m);
    part = around(needs, at(-12, 500), margin);
    CHECK(part.sun_elevation_deg.least == doctest::Approx(-12).epsilon(1e-9).scale(1e-300));
    CHECK(part.sun_elevation_deg.most > -12);
    CHECK(part.altitude_m.most == doctest::Approx(500).epsilon(1e-9).scale(1e-300));
}

TEST_CASE("planned sky: by moonlight it is planned for the moon, though the sun beyond the horizon is brighter") {
    const auto backend = open_cpu_float();
    PlanRequirements needs = day_and_dusk(two_hours().tolerance);
    needs.suns = 2;
    const auto planned = [&](const std::vector<Sun>& suns) {
        PlannedSky sky(backend->device(), needs, {}, {.margin = margin});
        (void)sky.update(camera_at(needs.air.planet, 2), suns);
        return sky.plan();
    };
    const Sun moon = dim(sun_at(40), 1e-6);
    const Plan by_night = planned({sun_at(-30), moon}), by_moon = planned({moon}), by_sun = planned({sun_at(-30)});
    CHECK(by_night.setting == by_moon.setting);
    CHECK(by_night.error.bound == by_moon.error.bound);
    CHECK(by_night.error.bound != by_sun.error.bound);
}

namespace {

/// Two hours of the day whose plans differ, less than two margins apart.
struct Boundary {
    double tolerance = 0, one = 0, other = 0;  // on the sun's axis
};
Boundary boundary() {
    constexpr double apart = 1.8 * margin;
    for (const double tolerance : {0.03, 0.05, 0.1, 0.2}) {
        const auto setting_at = [&](double sun) {
            return plan(around(day_and_dusk(tolerance), at(elevation_of(sun)), 2 * margin)).setting;
        };
        for (double sun = sun_axis(50); sun > sun_axis(-4); sun -= margin)
            if (!(setting_at(sun) == setting_at(sun - apart))) return {tolerance, sun, sun - apart};
    }
    FAIL("every hour has the same plan");
    return {};
}

}  // namespace

TEST_CASE("planned sky: a sun that goes to and fro about a boundary changes the sky once at most") {
    const auto backend = open_cpu_float();
    const Boundary where = boundary();
    Shown shown(*backend, where.tolerance, false, 0);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(elevation_of(where.one));
    (void)shown.show();
    int planned = 0, changed = 0;
    for (int turn = 0; turn < 8; ++turn) {
        const Setting before = shown.sky.plan().setting;
        const double sun = elevation_of(turn % 2 == 0 ? where.other : where.one);
        planned += shown.update(sun).planned ? 1 : 0;
        changed += shown.sky.plan().setting == before ? 0 : 1;
        for (int frame = 0; frame < 2; ++frame) {  // until a new sky is the only one
            (void)shown.show();
            (void)shown.update(sun);
        }
        CHECK(shown.sky.plan().tolerable);
    }
    CHECK(planned == 8);  // or there is nothing to see
    CHECK(changed <= 1);
}

TEST_CASE("planned sky: what is in use stays while it is good enough and as cheap within a tenth") {
    PlanRequirements needs = day_and_dusk(0.1);
    needs.sun_elevation_deg = {20, 30};
    const Plan best = plan(needs);
    REQUIRE(best.tolerable);
    std::size_t stays = 0, goes = 0;
    for (const PlanCandidate& one : best.candidates) {
        const Plan kept = plan_keeping(needs, one.setting);
        const bool good = one.excluded.empty() && one.tolerable && one.cost.charged_ms <= 1.1 * best.cost.charged_ms;
        CHECK(kept.setting == (good ? one.setting : best.setting));
        (good ? stays : goes) += 1;
        if (!good || one.setting == best.setting) continue;
        CHECK(kept.error.bound == one.error.bound);
        CHECK(kept.cost.charged_ms == one.cost.charged_ms);
        CHECK(kept.choices.front().reason.find(best.setting.id()) != std::string::npos);
    }
    CHECK(stays > 0);
    CHECK(goes > 0);
    CHECK(plan_keeping(needs, {"nobody", "default", "rgb", {}}).setting == best.setting);
}

namespace {

using Choices = std::set<std::pair<std::string, std::string>>;

Choices choices_of(const Plan& plan) {
    Choices all;
    for (const PlanChoice& choice : plan.choices) all.emplace(choice.what, choice.chosen);
    return all;
}

/// What two plans do not have in common, by name.
std::set<std::string> apart(const Plan& a, const Plan& b) {
    const Choices first = choices_of(a), second = choices_of(b);
    std::set<std::string> names;
    for (const Choices* one : {&first, &second})
        for (const auto& [what, how] : *one)
            if (!(one == &first ? second : first).contains({what, how})) names.insert(what);
    return names;
}

/// From the ground to space; how often the setting changes.
int climb(Backend& backend, double tolerance) {
    PlanRequirements needs = day_and_dusk(tolerance);
    needs.altitude_m = {2, 4e5};
    Shown shown(backend, needs, {.target_format = rhi::Format::rgba32_float}, {.margin = 0.5, .fade_frames = 0});
    const Sun sun = sun_at(50);
    const auto update = [&](double altitude) { return shown.sky.update(camera_at(needs.air.planet, altitude), {&sun, 1}); };
    (void)update(2);
    int changed = 0;
    for (const double altitude : {2.5e3, 2e4, 8e4, 2e5, 4e5}) {
        const Plan before = shown.sky.plan();
        const PlanUpdate now = update(altitude);
        const Plan& after = shown.sky.plan();
        INFO("tolerance ", tolerance, ", ", altitude, " m: ", before.setting.id(), ", then ", after.setting.id());
        CHECK(now.planned);
        std::set<std::string> named;
        for (const PlanChange& change : now.changes) {
            CHECK(named.insert(change.what).second);
            CHECK(change.before != change.after);
            CHECK_FALSE(change.reason.empty());
        }
        CHECK(named == apart(before, after));
        if (!(before.setting == after.setting)) {
            CHECK_FALSE(named.empty());
            ++changed;
        }
        for (int frame = 0; frame < 2; ++frame) {  // until a new sky is the only one
            (void)shown.show();
            (void)update(altitude);
        }
    }
    return changed;
}

}  // namespace

TEST_CASE("planned sky: a climb from the ground to space names everything that it changes, and nothing else") {
    const auto backend = open_cpu_float();
    int changed = 0;
    for (const double tolerance : {0.02, 0.05, 0.1, 0.2})
        if (changed == 0) changed = climb(*backend, tolerance);
    CHECK(changed > 0);
}

TEST_CASE("planned sky: before the first update there is nothing to show, and what is set is kept for it") {
    const auto backend = open_cpu_float();
    Shown shown(*backend, 0.2, false);
    CHECK(shown.sky.table_bytes() == 0);
    CHECK(shown.sky.plan().setting == plan(day_and_dusk(0.2)).setting);
    CHECK(backend->run([&](rhi::CommandList& commands) { shown.sky.record(commands); }).total() == 0);
    shown.sky.invalidate();
    CHECK_FALSE(shown.sky.light().before);
    for (const double wrong : {0.0, 1e31, std::numeric_limits<double>::quiet_NaN()})
        CHECK(rejected_field([&] { shown.sky.set_exposure(wrong); }) == "composite.exposure");
    shown.sky.set_exposure(20);
    shown.sky.prepare_composite(shown.targets);
    (void)shown.update(40);
    const CompositeSettings composite{.target_format = rhi::Format::rgba32_float, .exposure = 20};
    CHECK(shown.show() == alone(*backend, shown.sky.plan(), composite, 40));
}

TEST_CASE("planned sky: a camera or a sun that is nowhere is refused, and the plan stays") {
    const auto backend = open_cpu_float();
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    PlannedSky sky(backend->device(), day_and_dusk(0.1));
    const Camera camera = camera_at(presets::earth().planet, 2);
    const Sun sun = sun_at(20);
    (void)sky.update(camera, {&sun, 1});
    const Setting before = sky.plan().setting;
    const auto refused = [&](const Camera& eye, const Sun& light) {
        return rejected_field([&] { (void)sky.update(eye, {&light, 1}); });
    };
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name{"xyz"[axis]};
        Camera nowhere = camera;
        nowhere.position_m[axis] = not_a_number;
        CHECK(refused(nowhere, sun) == "camera.position_m." + name);
        Sun lost = sun;
        lost.direction[axis] = not_a_number;
        CHECK(refused(camera, lost) == "sun.direction." + name);
    }
    Sun nowhere = sun;
    nowhere.direction = glm::dvec3(0);
    CHECK(refused(camera, nowhere) == "sun.direction");
    Camera blind = camera;
    blind.view[1][2] = not_a_number;
    CHECK(refused(blind, sun) == "camera.view[1][2]");
    CHECK(sky.plan().setting == before);
    CHECK_FALSE(sky.update(camera, {&sun, 1}).planned);
}
