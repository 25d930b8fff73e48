#include "measure/truth.h"

#include "io/test_files.h"
#include "measure/compare.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::app;

namespace {

constexpr const char* suite_text = R"(
[[air]]
name = "earth"
[[scenes]]
class = "Day"
air = "earth"
sun_elevation_deg = [60, 0]
altitude_m = [2]
[[setting]]
model = "aureole"
)";

TruthTable::Entry entry(double value) { return {{Rgb(value, 2 * value, 3 * value), Rgb(1e-3 * value)}, 4096}; }

}  // namespace

TEST_CASE("truth: a table reads back as it was written, and knows what it lacks") {
    const Suite suite = parse_suite(suite_text, "s.toml");
    const TraceParameters parameters = truth_parameters(suite.airs[0]);
    const std::vector<ProbeRow> rows = truth_rows(suite, 0).at(0).rows;
    REQUIRE(rows.size() > 60);
    TruthTable table = TruthTable::read("no_such.csv", parameters);
    CHECK(table.size() == 0);
    CHECK(table.missing(rows, {}).size() == rows.size());
    for (std::size_t i = 1; i < rows.size(); ++i) table.set(rows[i], entry(1.0 / static_cast<double>(i)));
    table.write("truth_of_earth.csv", parameters);

    const TruthTable again = TruthTable::read("truth_of_earth.csv", parameters);
    CHECK(again.size() == rows.size() - 1);
    REQUIRE(again.find(rows[3]) != nullptr);
    CHECK(again.find(rows[3])->value.value.g == doctest::Approx(2.0 / 3).epsilon(1e-6).scale(1e-300));
    CHECK(again.find(rows[3])->value.error.r == doctest::Approx(1e-3 / 3).epsilon(1e-2).scale(1e-300));
    CHECK(again.find(rows[3])->paths == 4096);
    const std::vector<ProbeRow> missing = again.missing(rows, {});
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].view_zenith_deg == rows[0].view_zenith_deg);
    // Errors are 0.1 %: not as small as wanted, unless there may be no more paths.
    CHECK(again.missing(rows, {2e-3, 1 << 20}).size() == 1);
    CHECK(again.missing(rows, {5e-4, 1 << 20}).size() == rows.size());
    CHECK(again.missing(rows, {5e-4, 4096}).size() == 1);
    AirTruth truth{again, TruthTable(TruthKind::aerial), TruthTable(TruthKind::light)};
    CHECK(
        contains(complaint([&] { (void)places_of(suite, 0, truth); }), "earth.csv lacks scenes of the suite; `aureole truth`"));

    table.set(rows[0], entry(1));
    truth.sky = table;
    CHECK(contains(complaint([&] { (void)places_of(suite, 0, truth); }), "earth_light.csv lacks"));
    for (const SuiteScene& scene : suite.scenes)
        for (const LightPart part : {LightPart::sky, LightPart::sun}) truth.light.set(light_row(scene, part), entry(0.5));
    const std::vector<Place> places = places_of(suite, 0, truth);
    REQUIRE(places.size() == 2);
    CHECK(places[0].sky.value.r == 0.5);
    CHECK(places[1].points.size() == places[1].truth.size());
    CHECK(places[1].truth[5].value == table.find(places[1].points[5].row)->value.value);
}

TEST_CASE("truth: a table says by what seed and version it was made, and older ones are of the first") {
    const TraceParameters earth = truth_parameters({"a", presets::earth()});
    TruthTable table;
    table.set({}, entry(1));
    table.write("made_by.csv", earth);
    const std::string today = " seed=0 version=" + std::to_string(TruthMadeBy::present_version) + "\n";
    CHECK(contains(get("made_by.csv"), "spectral=rgb" + today));
    CHECK(TruthTable::read("made_by.csv", earth).made_by() == TruthMadeBy{});

    const auto after = [&](const std::string& end) {
        std::string text = get("made_by.csv");
        text.replace(text.find(" seed="), text.find('\n') - text.find(" seed="), end);
        put("older.csv", text);
        return TruthTable::read("older.csv", earth);
    };
    for (const std::string end : {"", " seed=0"}) {
        const TruthTable older = after(end);
        CHECK(older.made_by().seed.has_value() == !end.empty());
        CHECK_FALSE(older.made_by().version);
        // The tables that ship may grow until the path tracer draws otherwise.
        CHECK_NOTHROW(older.check_may_grow("older.csv", {.seed = 0, .version = 1}));
        CHECK(contains(complaint([&] { older.check_may_grow("older.csv", {.seed = 0, .version = 2}); }),
                       "older.csv: version: 1 is not allowed; allowed: 2;"));
        CHECK(contains(complaint([&] { older.check_may_grow("older.csv", {.seed = 1, .version = 1}); }),
                       "older.csv: seed: 0 is not allowed; allowed: 1;"));
        older.write("older.csv", earth);
        CHECK(contains(get("older.csv"), "spectral=rgb" + end + "\n"));
    }
    CHECK(contains(complaint([&] { after(" seed=7").check_may_grow("older.csv"); }), "older.csv: seed: 7"));
    CHECK(contains(complaint([&] { after(" seed=0 version=99").check_may_grow("older.csv"); }), "older.csv: version: 99"));
    CHECK(after(" seed=0 version=99").size() == 1);  // it is truth all the same
    CHECK(contains(complaint([&] { (void)after(" seed=x"); }), "seed=x"));
}

TEST_CASE("truth: a table of other air is refused by what differs") {
    const TraceParameters earth = truth_parameters({"a", presets::earth()});
    TruthTable().write("other.csv", earth);
    CHECK(contains(complaint([&] { (void)TruthTable::read("other.csv", earth); }), "no row"));
    TruthTable table;
    table.set({}, entry(1));
    table.write("other.csv", earth);
    AtmosphereParameters bright = presets::earth();
    bright.planet.ground_albedo = Rgb(0.5);
    CHECK(contains(complaint([&] {
                       (void)TruthTable::read("other.csv", truth_parameters({"a", bright}));
                   }),
                   "\"ground_albedo=0.3,0.3,0.3\" there, \"ground_albedo=0.5,0.5,0.5\" here"));
    CHECK(contains(complaint([&] {
                       (void)TruthTable::read("other.csv", truth_parameters({"a", presets::earth(), "40"}));
                   }),
                   "\"spectral=rgb\" there, \"spectral=40\" here"));
}
