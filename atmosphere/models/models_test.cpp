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
    CHECK(rejected_field([&] { (void)models::aureole(quality); }) == "aureole.sky_view_nodes");
}
