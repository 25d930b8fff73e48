// The worst scenes that long searches have found (stability_envelope search) are no worse now, and a short search finds none
// that is worse.
#include "stability/search.h"
#include "stability/cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string_view>

using namespace aureole;
using namespace aureole::stability;

TEST_CASE("stability, whole models: float loses no more than stated anywhere that a search finds" *
          doctest::test_suite("long")) {
    const Range range = cases(8);
    for (const Rung& rung : searched_rungs()) {
        ModelError error(rung);
        for (const Subject subject : {Subject::sky, Subject::geometry}) {
            INFO(std::string(rung.name), subject == Subject::sky ? ", sky" : ", geometry");
            double bound = 0;
            for (const KeptScene& scene : kept_scenes())
                if (std::string_view(scene.rung) == rung.name && scene.subject == subject) {
                    INFO(text_of(scene_at(scene.at, subject)));
                    CHECK(error(scene_at(scene.at, subject), subject) <= scene.bound);
                    bound = std::max(bound, scene.bound);
                }
            REQUIRE(bound > 0);
            const WorstScene found = search(error, subject, range.begin + 2, std::max<std::uint64_t>(range.end, 4));
            INFO(text_of(scene_at(found.at, subject)));
            CHECK(found.error <= bound);
        }
    }
}
