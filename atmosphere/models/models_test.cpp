#include "common/rejects.h"

#include <aureole/atmosphere.h>
#include <aureole/models/aureole.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <algorithm>

using namespace aureole;
using detail::rejected_field;

TEST_CASE("models: by name and quality") {
    CHECK(std::ranges::find(model_names(), "aureole") != model_names().end());
    for (const std::string_view name : model_names()) {
        CAPTURE(name);
        CHECK(model_summary(name).size() > 10);
        for (const std::string_view quality : quality_names()) {
            const ModelPtr model = model_by_name(name, quality);
            REQUIRE(model);
            CHECK(model->name() == name);
            CHECK_NOTHROW(model->validate());
        }
    }
    CHECK(rejected_field([] { (void)model_summary("preetham"); }) == "model");
    CHECK(rejected_field([] { (void)model_by_name("preetham"); }) == "model");
    CHECK(rejected_field([] { (void)model_by_name("aureole", "ultra"); }) == "quality");
}

TEST_CASE("models: settings are checked when a model is made") {
    QualitySettings quality;
    quality.sky_view_nodes = 0;
    CHECK(rejected_field([&] { (void)models::aureole(quality); }) == "sky_view_nodes");
}

TEST_CASE("aureole: as many moments as an air can make use of, where the quality leaves it open") {
    const ModelPtr high = models::aureole(QualitySettings::high());
    CHECK(high->quality().angular_order == 8);
    CHECK(high->quality_for(presets::earth()).angular_order == 2);
    CHECK(high->quality_for(presets::hazy_earth()).angular_order == 8);
    CHECK(high->quality_for(presets::mars()).angular_order == 8);
    CHECK(high->quality_for(presets::airless()).angular_order == 0);
    CHECK(high->quality_for(presets::mars()).multi_scatter_azimuth == 10);
    AtmosphereParameters clean = presets::earth();
    std::erase_if(clean.terms, [](const DensityTerm& term) { return term.name == "mie"; });
    CHECK(high->quality_for(clean).angular_order == 2);
    for (DensityTerm& term : clean.terms) term.scattering_per_m *= 0.01;
    CHECK(high->quality_for(clean).angular_order == 0);  // next to nothing is scattered twice
    CHECK(models::aureole()->quality_for(presets::earth()).angular_order == 2);
    CHECK(models::aureole()->quality_for(presets::mars()).angular_order == 4);
}
