#include "plan/work.h"

#include <aureole/models/aureole.h>
#include <aureole/presets.h>
#include <aureole/setting.h>

#include <doctest/doctest.h>

using namespace aureole;
using detail::table_work;
using detail::TableWork;

TEST_CASE("work: tables of the air of some models take the same in every air") {
    for (const char* name : {"hillaire", "bruneton"}) {
        const ModelPtr model = model_by_name(name);
        CAPTURE(name);
        CHECK(table_work(*model, presets::earth()) == table_work(*model, presets::mars()));
        CHECK(table_work(*model, presets::earth()).rebuild == 1);
    }
}

TEST_CASE("work: a column through more layers takes more, wherever a model integrates one") {
    const auto of = [](const char* model, const char* quality, const AtmosphereParameters& air) {
        return table_work(*model_by_name(model, quality), air);
    };
    const AtmosphereParameters earth = presets::earth(), mars = presets::mars();  // without ozone's tent
    for (const char* quality : {"low", "default", "high"}) {
        const double columns = of("fog", quality, earth).composite / of("fog", quality, mars).composite;
        CHECK(columns ==
              doctest::Approx(5.3).epsilon(0.1).scale(1e-300));  // measured of fog, single and single-lut: 5.0 to 5.6
        CHECK(of("fog", quality, earth).light / of("fog", quality, mars).light == columns);
        CHECK(of("single", quality, earth).light / of("single", quality, mars).light == columns);
        CHECK(of("single-lut", quality, earth).rebuild / of("single-lut", quality, mars).rebuild == columns);
        CHECK(of("single-lut", quality, earth).composite == 1);
    }
    CHECK(of("single", "default", earth).composite > 5 * of("single", "default", mars).composite);
    CHECK(of("single", "default", earth).view == 1);
    CHECK(of("single", "low", earth).view > 5);  // its dome
    CHECK(of("single", "low", earth).composite == 1);
    // Its molecules are in a table; measured of fog, single and single-lut: 1.9 to 2.5.
    const double tabulated =
        of("fog", "default", presets::us_standard_1976()).composite / of("fog", "default", earth).composite;
    CHECK(tabulated == doctest::Approx(2.2).epsilon(0.1).scale(1e-300));
    CHECK(of("fog", "default", presets::airless()).composite == 1);
}

TEST_CASE("work: more where phase functions are sharp, where orders fade slowly, and for every phase function that may peak") {
    const ModelPtr model = models::aureole();
    const TableWork earth = table_work(*model, presets::earth()), haze = table_work(*model, presets::hazy_earth());
    CHECK(haze.rebuild > 2 * earth.rebuild);  // moments to order 4 in place of 2
    CHECK(haze.view == earth.view + 9);
    CHECK(haze.air_memory > 1.5 * earth.air_memory);
    CHECK(haze.view_memory == earth.view_memory);
    // Light is scattered there dozens of times.
    CHECK(table_work(*model, presets::titan()).rebuild > 2 * haze.rebuild);
    AtmosphereParameters clean = presets::earth();
    std::erase_if(clean.terms, [](const DensityTerm& term) { return term.name == "mie"; });
    CHECK(table_work(*model, clean).view_memory == earth.view_memory - 1);
    CHECK(table_work(*model, clean).aerial_perspective_memory == earth.aerial_perspective_memory - 1);
}

TEST_CASE("work: without multiple scattering there is its transmittance alone, over half floats in half the memory") {
    const auto of = [](std::vector<std::string> without) {
        const auto prepared = prepare({"aureole", "default", "rgb", std::move(without)}, presets::mars()).value();
        return table_work(*prepared.model, prepared.air);
    };
    const TableWork single = of({"multiple scattering"}), half = of({"multiple scattering", "float tables"});
    CHECK(single.rebuild < 0.1 * of({}).rebuild);
    CHECK(half.rebuild == single.rebuild);
    CHECK(half.air_memory == single.air_memory / 2);
}
