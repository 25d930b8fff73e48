#include "measure/measure.h"

#include "io/file.h"
#include "io/test_files.h"
#include "report/report.h"

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::app;
using nlohmann::json;

namespace {

constexpr const char* suite_text = R"(
[[air]]
name = "earth"
[[scenes]]
class = "Day"
air = "earth"
aerial = true
sun_elevation_deg = [60, 3]
altitude_m = [2]
[[setting]]
model = "single-lut"
quality = ["low", "default"]
[[setting]]
model = "single-lut"
without = "ozone"
[[setting]]
model = "single-lut"
without = "dust"
)";

/// A suite whose truth is a model's own, as fine as that gets: what the model itself is wrong by is nothing.
Suite with_own_truth(Backend& exact) {
    std::filesystem::remove_all("measured");
    std::filesystem::create_directories("measured/truth");
    Suite suite = parse_suite(suite_text, "measured/s.toml");
    const std::vector<ProbeRow> rows = truth_rows(suite, 0).at(0).rows;
    const Prepared fine = prepare(converged(suite.settings[0]), suite.airs[0].parameters).value();
    const std::vector<Rgb> radiance = probe(exact, fine.air, fine.model, rows);
    TruthTable table;
    const TraceParameters parameters = truth_parameters(suite.airs[0]);
    for (std::size_t i = 0; i < rows.size(); ++i) table.set(rows[i], {{radiance[i], Rgb(0)}, 1});
    table.write(truth_file(suite, suite.airs[0], TruthKind::sky), parameters);

    TruthTable pixels(TruthKind::aerial), lights(TruthKind::light);
    std::vector<AerialView> views;
    std::vector<LightPlace> light_places;
    for (const SuiteScene& scene : suite.scenes) {
        views.push_back(aerial_view(scene));
        light_places.push_back({scene.sun_zenith_deg(), scene.altitude_km()});
    }
    const auto pictures = aerial(exact, fine.air, fine.model, views);
    const std::vector<MeasuredLight> light = app::light(exact, fine.air, fine.model, light_places);
    for (std::size_t i = 0; i < suite.scenes.size(); ++i) {
        for (std::size_t j = 0; j < aerial_pixels; ++j) pixels.set(aerial_row(views[i], j), {{pictures[i][j], Rgb(0)}, 1});
        lights.set(light_row(suite.scenes[i], LightPart::sky), {{light[i].sky_irradiance_up, Rgb(0)}, 1});
        lights.set(light_row(suite.scenes[i], LightPart::sun), {{light[i].sun_irradiance, Rgb(0)}, 1});
    }
    pixels.write(truth_file(suite, suite.airs[0], TruthKind::aerial), parameters);
    lights.write(truth_file(suite, suite.airs[0], TruthKind::light), parameters);
    return suite;
}

json measured(const Suite& suite, Backend& run, Backend& exact) {
    return measure(suite, {.out = "measured"}, run, exact, [](std::size_t, std::size_t) {});
}

const json& result(const json& all, const std::string& scene, const std::string& setting) {
    for (const json& one : all.at("results"))
        if (one.at("scene") == scene && one.at("setting") == setting) return one;
    FAIL("no result of " << setting << " in " << scene);
    throw 0;
}

/// Of every region, and of light: the parts together bound the error, and none is there without the others.
void check_split(const json& one) {
    std::size_t regions = 0;
    for (const auto& [key, region] : one.at("regions").items()) {
        if (region.at("rows") == 0) continue;
        const std::string& name = key;
        CAPTURE(name);
        const json& split = one.at("split").at(name);
        for (const char* part : {"rounding", "discretisation", "model", "sum"})
            CHECK(split.at(part).at("rows") == region.at("rows"));
        for (const char* quantile : {"median", "p95", "max"}) {
            CHECK(split.at("sum").at(quantile).get<double>() >= region.at(quantile).get<double>() * (1 - 1e-9));
            CHECK(split.at("sum").at(quantile) >= split.at("model").at(quantile));
        }
        ++regions;
    }
    CHECK(regions == one.at("split").size());
    CHECK(one.at("split").contains("aerial"));
    for (const char* figure : {"sky_illuminance", "sun_colour"}) {
        const json& parts = one.at("figure_split").at(figure);
        const double sum =
            parts.at("rounding").get<double>() + parts.at("discretisation").get<double>() + parts.at("model").get<double>();
        CHECK(sum >= one.at(figure).get<double>() * (1 - 1e-9));
        CHECK(parts.at("rounding") < 1e-3);
    }
}

}  // namespace

TEST_CASE("measure: errors and their parts, where they are known otherwise" * doctest::test_suite("long")) {
    const auto run = open_backend({.name = "cpu"}), exact = open_backend({.name = "cpu-double"});
    const Suite suite = with_own_truth(*exact);
    const json all = measured(suite, *run, *exact);
    CHECK(all.at("suite") == "s");
    CHECK(all.at("scenes").size() == 2);
    CHECK(all.at("settings").size() == 4);
    for (const json& scene : all.at("scenes")) {  // without the air before it, what is farther is farther off
        REQUIRE(scene.at("bare").size() == detail::bare_distances_km.size());
        CHECK(scene.at("extinction_per_km") > 0);
        for (std::size_t i = 1; i < detail::bare_distances_km.size(); ++i)
            CHECK(scene.at("bare")[i].at("median") > scene.at("bare")[i - 1].at("median"));
    }
    CHECK(all.at("results").size() == 6);                                       // there is no dust to be left out
    CHECK(contains(markdown_tables(all), "| ozone | single-lut default | +"));  // the report reads what is written
    for (const char* scene : {"earth/sun60/2m", "earth/sun3/2m"}) {
        CAPTURE(scene);
        const json& low = result(all, scene, "single-lut low");
        const json& standard = result(all, scene, "single-lut default");
        const json& dry = result(all, scene, "single-lut default, without ozone");
        const double coarse = low.at("regions").at("all").at("p95");
        const double fine = standard.at("regions").at("all").at("p95");
        CHECK(coarse > fine);
        CHECK(fine < 0.02);
        // The truth is the model's own, rounded to float.
        CHECK(standard.at("split").at("all").at("model").at("max") < 1e-5);
        CHECK(low.at("split").at("all").at("rounding").at("max") < 1e-3);
        CHECK(low.at("split").at("all").at("discretisation").at("p95") == doctest::Approx(coarse).epsilon(0.05).scale(1e-300));
        // Without ozone it is another model, whose own finest setting is as wrong.
        CHECK(dry.at("split").at("all").at("model").at("median") >
              5 * dry.at("split").at("all").at("discretisation").at("median").get<double>());
        CHECK(low.at("delta_e").at("p95") > 0);
        CHECK(low.at("luminance_rmse") > standard.at("luminance_rmse"));
        CHECK(standard.at("banding_delta_e") < 1);
        CHECK(low.at("regions").at("aerial").at("rows") == 48);  // the lower half of the picture is too near
        CHECK(standard.at("sky_illuminance") < 0.01);
        CHECK(dry.at("sky_illuminance") > standard.at("sky_illuminance"));
        CHECK(dry.at("sun_colour") > 10 * standard.at("sun_colour").get<double>());
        for (const json* one : {&low, &standard, &dry}) check_split(*one);
        std::size_t rows = 0;
        for (const auto& [name, region] : low.at("regions").items())
            if (name != "all" && !name.starts_with("aerial")) rows += region.at("rows").get<std::size_t>();
        const json& regions = low.at("regions");
        CHECK(regions.at("aerial near").at("rows").get<int>() + regions.at("aerial far").at("rows").get<int>() == 48);
        CHECK(rows == low.at("regions").at("all").at("rows"));
        CHECK(rows == low.at("regions").at("all").at("asked"));
        // Geometry's parts are of geometry: of the model's own truth nothing is the model's.
        CHECK(standard.at("split").at("aerial").at("model").at("max") < 1e-4);
        CHECK(dry.at("split").at("aerial").at("model").at("p95") > 1e-3);
        CHECK(dry.at("figure_split").at("sun_colour").at("model") >
              10 * dry.at("figure_split").at("sun_colour").at("discretisation").get<double>());
    }
}

TEST_CASE("measure: goes on from what is finished, and not from what was something else") {
    const auto run = open_backend({.name = "cpu"}), exact = open_backend({.name = "cpu-double"});
    Suite suite = with_own_truth(*exact);
    suite.settings.resize(2);
    const json first = measured(suite, *run, *exact);
    const std::filesystem::path item = "measured/items/earth/single-lut_low.json";
    json kept = json::parse(get(item.string()));
    kept.at("results")[0]["luminance_rmse"] = 42;
    put(item.string(), kept.dump());
    CHECK(result(measured(suite, *run, *exact), "earth/sun60/2m", "single-lut low").at("luminance_rmse") == 42);

    kept.at("key")["device"] = "another";
    put(item.string(), kept.dump());
    CHECK(measured(suite, *run, *exact) == first);
    put(item.string(), kept.dump().substr(0, 100));  // half a file
    CHECK(measured(suite, *run, *exact) == first);
}
