// Plans in every measured scene, of the suites' own airs, too: the library knows of the presets alone.
#include "measure/suite.h"
#include "plan/test_scenes.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

using namespace aureole;
using namespace aureole::app;
using namespace aureole::detail;

namespace {

std::map<std::string, AtmosphereParameters> suite_airs() {
    const std::filesystem::path folder = std::filesystem::path(AUREOLE_SCENES).parent_path() / "suites";
    std::map<std::string, AtmosphereParameters> airs;
    for (const char* name : {"small.toml", "full.toml"})
        for (const SuiteAir& air : read_suite(folder / name).airs) airs[air.name] = air.parameters;
    return airs;
}

/// Any setting has what the requirements ask of it measured there.
bool is_known(const PlanRequirements& needs, const MeasuredSkies& skies, std::size_t scene) {
    return std::ranges::any_of(skies.settings, [&](const auto& one) { return measured_worst(needs, one, scene).has_value(); });
}

/// How far geometry goes in the plans of a scene, in km; 0: there is none. Near, far and without in turn. What the planner
/// knows of geometry without the air before it, it knows at these near ones.
constexpr std::array near_km{0.0316, 0.316, 3.16};
double reach_of(const PlanRequirements& needs, const MeasuredSkies& skies, std::size_t scene) {
    PlanRequirements through_air = needs;
    through_air.geometry = true;
    through_air.light = false;
    if (!is_known(through_air, skies, scene) || scene % 4 == 1) return 0;
    return scene % 4 == 0 ? 96 : near_km[scene / 2 % near_km.size()];
}

/// Under AddressSanitizer each third scene is looked at, which is still every kind of requirements that reach_of() makes.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t scenes_apart = 3;
#else
constexpr std::size_t scenes_apart = 1;
#endif

void check_every_scene(const MeasuredSkies& skies, bool wavelengths) {
    const auto airs = suite_airs();
    const Predictor predictor(skies);
    Planned all;
    std::size_t looked_at = 0, with_geometry = 0, with_bare = 0;
    for (std::size_t scene = 0; scene < skies.scenes.size(); scene += scenes_apart) {
        INFO(skies.airs[skies.scenes[scene].air]);
        REQUIRE(airs.contains(skies.airs[skies.scenes[scene].air]));
        PlanRequirements needs;
        needs.air = airs.at(skies.airs[skies.scenes[scene].air]);
        needs.wavelengths = wavelengths;
        const double km = reach_of(needs, skies, scene);
        needs.geometry = km > 0;
        if (needs.geometry) needs.geometry_range_m = 1000 * km;
        needs.light = true;
        needs.light = is_known(needs, skies, scene);
        if (!is_known(needs, skies, scene)) continue;
        ++looked_at;
        with_geometry += needs.geometry ? 1 : 0;
        with_bare += measured_bare(needs, skies, scene) ? 1 : 0;
        const Planned here = check_plans_of(needs, predictor, scene);
        all.planned += here.planned;
        all.refused += here.refused;
        all.of_air += here.of_air;
    }
    CHECK(scenes_apart * with_geometry > 3);
    CHECK(scenes_apart * looked_at > skies.scenes.size() / 2);
    CHECK(all.planned > 2 * looked_at);
    CHECK(all.refused > 0);  // half a percent in twilight
    CHECK(all.of_air == 11 * with_bare);
    if (!wavelengths) CHECK(scenes_apart * with_bare > 10);
}

}  // namespace

TEST_CASE("plan: in every measured scene, for every tolerance, it is the cheapest measured setting that meets it" *
          doctest::test_suite("long")) {
    SUBCASE("in red, green and blue") { check_every_scene(measured_in_rgb(), false); }
    SUBCASE("in wavelengths") { check_every_scene(measured_in_wavelengths(), true); }
}
