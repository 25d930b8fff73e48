#include "common/rejects.h"

#include <aureole/models/aureole.h>
#include <aureole/presets.h>
#include <aureole/setting.h>

#include <doctest/doctest.h>

using namespace aureole;
using detail::rejected_field;

TEST_CASE("setting: what a model does not have cannot be left out of it") {
    const auto rejects = [](const char* model, const char* quality, const char* what) {
        return rejected_field([&] { validate(Setting{model, quality, "rgb", {what}}); }) == "without";
    };
    CHECK(rejects("fog", "default", "half the samples"));
    CHECK(rejects("single", "default", "float tables"));
    CHECK(rejects("hillaire", "default", "ground light"));
    CHECK(rejects("hillaire", "default", "coloured transmittance"));  // has none
    CHECK_FALSE(rejects("hillaire", "high", "coloured transmittance"));
    CHECK(rejects("bruneton", "default", "multiple scattering"));
    CHECK(rejects("aureole", "default", "wavelengths"));  // in red, green and blue
    for (const std::string_view name :
         {"multiple scattering", "its direction", "ground light", "half the samples", "float tables"})
        CHECK_NOTHROW(validate(Setting{"aureole", "default", "rgb", {std::string(name)}}));
}

TEST_CASE("setting: what is left out is gone, and converged settings leave out the same light") {
    const AtmosphereParameters earth = presets::earth();
    const auto quality = [&](const std::vector<std::string>& without) {
        return prepare(Setting{"aureole", "default", "rgb", without}, earth).value().model->quality();
    };
    QualitySettings expected;
    CHECK(quality({}) == expected);
    expected.multi_scatter_orders = 0;
    CHECK(quality({"multiple scattering"}) == expected);
    expected = {};
    expected.angular_order = 0;
    expected.angular_order_as_needed = false;
    CHECK(quality({"its direction"}) == expected);
    CHECK_FALSE(quality({"ground light"}).ground_light);
    CHECK(quality({"half the samples"}).sky_view_nodes == 5);
    CHECK(quality({"float tables"}).table_format == rhi::Format::rgba16_float);

    const Prepared clear = prepare(Setting{"aureole", "default", "rgb", {"mie", "ozone"}}, earth).value();
    REQUIRE(clear.air.terms.size() == 1);
    CHECK(clear.air.terms[0].name == "rayleigh");
    CHECK_FALSE(prepare(Setting{"aureole", "default", "rgb", {"ozone"}}, presets::mars()).has_value());

    const Setting fine =
        converged(Setting{"aureole", "low", "rgb", {"ozone", "half the samples", "ground light", "float tables"}});
    CHECK(fine.quality == "converged");
    CHECK(fine.without == std::vector<std::string>{"ozone", "ground light", "its direction"});
    CHECK(converged(Setting{"hillaire", "default", "rgb", {}}).without == std::vector<std::string>{"coloured transmittance"});
    CHECK(converged(Setting{"hillaire", "high", "rgb", {}}).without.empty());
    CHECK(converged(Setting{"fog", "low", "rgb", {}}).quality == "low");
    for (const std::string_view name : model_names())
        for (const std::string_view quality : quality_names())
            CHECK_NOTHROW(validate(converged(Setting{std::string(name), std::string(quality), "rgb", {}})));
}

TEST_CASE("setting: the model in red, green and blue is one without its wavelengths") {
    const AtmosphereParameters earth = presets::earth();
    const ModelPtr coloured = prepare(Setting{"aureole", "default", "4", {}}, earth).value().model;
    const ModelPtr rgb = prepare(Setting{"aureole", "default", "4", {"wavelengths"}}, earth).value().model;
    CHECK(rgb->by_tables());
    CHECK_FALSE(coloured->by_tables());
}

TEST_CASE("setting: ids name all that there is") {
    CHECK(Setting{}.id() == "aureole default");
    CHECK(Setting{}.baseline().empty());
    const Setting full{"aureole", "low", "4", {"ozone", "mie"}};
    CHECK(full.id() == "aureole low 4, without ozone and mie");
    CHECK(full.baseline() == "aureole low 4");
    CHECK(rejected_field([] { validate(Setting{.model = "nishita"}); }) == "model");
    CHECK(rejected_field([] { validate(Setting{.quality = "best"}); }) == "quality");
    CHECK(rejected_field([] { validate(Setting{.spectral = "2"}); }) == "spectral");
    CHECK(rejected_field([] { validate(Setting{.without = {"mie", "mie"}}); }) == "without");
}
