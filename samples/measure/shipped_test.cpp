// The planner's table is of the models as they are: some of its scenes measured again.
#include "app/solution.h"
#include "measure/compare.h"
#include "plan/measured.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace aureole;
using namespace aureole::app;

namespace {

double error_in(const detail::MeasuredError& of, std::size_t scene) { return std::exp(of.by_scene.at(scene) / 1000.0); }

}  // namespace

TEST_CASE("measure: the table that ships is of the models as they are" * doctest::test_suite("long")) {
    const detail::MeasuredSkies& skies = detail::measured_in_rgb();
    const std::filesystem::path folder = std::filesystem::path(AUREOLE_SCENES).parent_path() / "suites";
    const Suite suite = read_suite(folder / "small.toml");
    const auto cpu = open_backend({.name = "cpu"});
    std::size_t compared = 0;
    for (const char* air_name : {"earth", "mars"}) {
        const auto air =
            static_cast<std::size_t>(std::ranges::find(suite.airs, air_name, &SuiteAir::name) - suite.airs.begin());
        const std::vector<Place> places = places_of(suite, air, read_truth(suite, air));
        for (const Setting& setting : {Setting{"aureole", "low", "rgb", {}}, Setting{"aureole", "default", "rgb", {}},
                                       Setting{"hillaire", "low", "rgb", {}}}) {
            const auto known = std::ranges::find(skies.settings, setting, &detail::MeasuredSetting::setting);
            REQUIRE(known != skies.settings.end());
            const Prepared prepared = prepare(setting, suite.airs[air].parameters).value();
            const auto solved_air = solved(*cpu, prepared.air, prepared.model);
            const std::vector<Seen> seen = look(*cpu, *solved_air, suite, places);
            for (std::size_t i = 0; i < places.size(); ++i) {
                const std::string id = suite.id(suite.scenes[places[i].scene]);
                const auto scene = std::ranges::find(skies.scenes, id, &detail::MeasuredScene::id);
                if (scene == skies.scenes.end()) continue;
                CAPTURE(setting.id());
                CAPTURE(id);
                const auto at = static_cast<std::size_t>(scene - skies.scenes.begin());
                const SceneResult result = compare(places[i], {&seen[i]});
                // Drivers round in their own ways, and noise of half a per cent of the truth is the same in both.
                CHECK(result.all.p95 == doctest::Approx(error_in(known->sky_p95, at)).epsilon(0.03).scale(1e-300));
                CHECK(result.all.median == doctest::Approx(error_in(known->sky_median, at)).epsilon(0.05).scale(1e-300));
                ++compared;
            }
        }
    }
    CHECK(compared >= 30);
}
