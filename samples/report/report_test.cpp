#include "report/report.h"

#include "io/test_files.h"
#include "report/numbers.h"
#include "report/page.h"
#include "report/summary.h"

#include <doctest/doctest.h>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace aureole::app;
using namespace aureole::app::report;
using nlohmann::json;

namespace {

/// Hand-made: three scenes in two classes, four settings.
json example() { return json::parse(get(AUREOLE_REPORT_EXAMPLE)); }

std::vector<ClassSummary> summaries(const json& measurements) { return summarize(read_measurements(measurements, "m.json")); }

/// What is said about the example after a change.
std::string after(const std::function<void(json&)>& change) {
    json measurements = example();
    change(measurements);
    return complaint([&] { (void)read_measurements(measurements, "m.json"); });
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The cell of a CSV line in the column of that name; quoted cells hold no comma before it.
std::string cell(const std::vector<std::string>& lines, std::size_t line, const std::string& column) {
    const auto split = [](const std::string& text) {
        std::vector<std::string> cells(1);
        bool quoted = false;
        for (const char c : text)
            if (c == '"')
                quoted = !quoted;
            else if (c == ',' && !quoted)
                cells.emplace_back();
            else
                cells.back() += c;
        return cells;
    };
    const std::vector<std::string> names = split(lines[0]), cells = split(lines[line]);
    REQUIRE(names.size() == cells.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == column) return cells[i];
    return "no such column";
}

}  // namespace

TEST_CASE("report: short numbers") {
    CHECK(short_number(0) == "0");
    CHECK(short_number(12345) == "12345");
    CHECK(short_number(123.4) == "123");
    CHECK(short_number(1.2345) == "1.23");
    CHECK(short_number(1.5) == "1.5");
    CHECK(short_number(-0.012345) == "-0.0123");
    CHECK(short_number(0.000071) == "0.0001");
    CHECK(short_number(0.00001) == "<0.0001");
    CHECK(short_number(INFINITY) == "∞");
    CHECK(in_unit(0.0123, Unit::percent) == "1.23");
    CHECK(in_unit(3 * 1048576, Unit::bytes) == "3");
    CHECK(in_unit(999, Unit::count) == "999");
    CHECK(in_unit(12300, Unit::count) == "12.3 k");
    CHECK(in_unit(-1.23e9, Unit::count) == "-1.23 G");
}

TEST_CASE("report: scenes become a class by median of medians and by the worst of the rest") {
    const std::vector<ClassSummary> classes = summaries(example());
    REQUIRE(classes.size() == 2);
    CHECK(classes[0].name == "Earth by day");
    CHECK(classes[0].scenes == 2);
    REQUIRE(classes[0].settings.size() == 4);
    const Summary& of = classes[0].settings[1];  // aureole default: medians 0.002 and 0.004
    CHECK(of.scenes == 2);
    CHECK(of.regions.at("all").median == doctest::Approx(0.003));
    CHECK(of.regions.at("all").p95 == doctest::Approx(0.016));
    CHECK(of.regions.at("all").max == doctest::Approx(0.04));
    CHECK(of.regions.at("aureole").p95 == doctest::Approx(0.016));
    CHECK_FALSE(of.regions.contains("nadir"));   // no directions
    CHECK_FALSE(of.regions.contains("aerial"));  // not in the file
    CHECK(of.split.at("all").at("model").median == doctest::Approx(0.0024));
    CHECK(of.split.at("all").at("rounding").max == doctest::Approx(0.002));
    CHECK(of.errors.at("luminance_rmse") == doctest::Approx(0.006));
    CHECK(of.errors.at("delta_e_p95") == doctest::Approx(0.24));
    CHECK(of.costs.at("per_frame_ms") == 0.5);
    CHECK(of.costs.at("rebuild_fetches") == 2700000);
    CHECK_FALSE(of.costs.contains("composite_ms"));
    CHECK(classes[1].settings.size() == 3);       // no ozone on Mars
    CHECK(classes[1].settings[2].costs.empty());  // aureole high: not measured there
    CHECK(classes[1].settings[0].split.empty());  // hillaire: not measured there
    CHECK(classes[1].settings[1].costs.at("per_frame_ms") == 1);
}

TEST_CASE("report: errors by the sun's elevation are of the scenes that have it") {
    const std::vector<ClassSummary> classes = summaries(example());
    REQUIRE(classes[0].by_sun.size() == 2);
    CHECK(classes[0].by_sun.begin()->first == 10);
    CHECK(classes[0].by_sun.at(10)[1].regions.at("all").median == 0.004);
    CHECK(classes[0].by_sun.at(60)[1].regions.at("all").median == 0.002);
}

TEST_CASE("report: a simplification is compared with its baseline in the scenes that both have") {
    json measurements = example();
    std::vector<ClassSummary> classes = summaries(measurements);
    REQUIRE(classes[0].simplifications.size() == 1);
    CHECK(classes[1].simplifications.empty());
    const Simplification& both = classes[0].simplifications[0];
    CHECK(both.scenes == 2);
    CHECK(*both.added_median == doctest::Approx(0.04 - 0.003));
    CHECK(*both.added_p95 == doctest::Approx(0.2 - 0.016));
    CHECK(both.saved.at("per_frame_fetches") == Saving{200000, 200000.0 / 900000});
    // Without the baseline in the scene of 10 degrees, that of 60 is what is left.
    json& results = measurements["results"];
    results.erase(std::find_if(results.begin(), results.end(), [](const json& result) {
        return result["scene"] == "earth/sun10/2m" && result["setting"] == "aureole default";
    }));
    classes = summaries(measurements);
    CHECK(classes[0].simplifications[0].scenes == 1);
    CHECK(*classes[0].simplifications[0].added_median == doctest::Approx(0.03 - 0.002));
}

TEST_CASE("report: an infinite error stays one") {
    json measurements = example();
    measurements["results"][1]["regions"]["all"]["max"] = nullptr;
    CHECK(std::isinf(summaries(measurements)[0].settings[1].regions.at("all").max));
    CHECK(contains(markdown_tables(measurements), "| aureole default | 0.3 | 1.6 | ∞ |"));
    CHECK(cell(lines_of(csv_lines(measurements)), 2, "all_max") == "inf");
    // Of three scenes the middle one counts, however bad the last is.
    measurements["scenes"][2]["class"] = "Earth by day";
    for (const char* which : {"median", "p95", "max"}) measurements["results"][9]["regions"]["all"][which] = nullptr;
    REQUIRE(measurements["results"][9]["setting"] == "aureole default");
    CHECK(summaries(measurements)[0].settings[1].regions.at("all").median == 0.004);
}

TEST_CASE("report: tables in Markdown") {
    const std::string tables = markdown_tables(example());
    CHECK(contains(tables,
                   "Suite `example`, Aureole 0.1.0. Errors: CPU backend, float, 2 threads. Costs: llvmpipe (Mesa 22.3.6)."));
    CHECK(contains(tables, "\n## Earth by day\n\n2 scenes.\n"));
    CHECK(contains(tables,
                   "| aureole default | 0.3 | 1.6 | 4 | – | – | 0.6 | 0.24 | 0.28 | 0.04 | 0.2 | 0.5 (0.45 to 0.6) | 2 (1.8 to "
                   "2.4) | 400 k | 900 k | 1 |"));
    CHECK(contains(tables, "| aureole high | 0.3 | 1.2 | 3 | – | – | 0.45 | 0.18 | 0.21 | 0.03 | 0 | – | – | – | – | – |"));
    CHECK(contains(tables, "| aureole default | 0.015 | 0.08 | 0.2 | 0.09 | 0.48 | 1.2 | 0.24 | 1.28 | 3.2 | – |"));
    CHECK(contains(
        tables,
        "| ozone | aureole default | +3.7 | +18.4 | – | – | 0.1 (20 %) | 0.2 (10 %) | 0 (0 %) | 200 k (22 %) | 0 (0 %) |"));
    CHECK(contains(tables, "What simplifications cost was not measured."));
    // Every line of a table has as many cells as its heading.
    std::size_t cells = 0, tables_seen = 0;
    for (const std::string& line : lines_of(tables)) {
        const auto bars = static_cast<std::size_t>(std::count(line.begin(), line.end(), '|'));
        if (bars == 0) cells = 0;
        if (bars != 0 && cells == 0) cells = bars, ++tables_seen;
        CHECK(bars == cells);
    }
    CHECK(tables_seen == 11);
}

TEST_CASE("report: geometry by its distance, and what it is without the air before it") {
    json measurements = example();
    const auto bare = [](double km, double median, double p95) {
        return json{{"distance_km", km}, {"rows", 5}, {"median", median}, {"p95", p95}, {"max", p95}};
    };
    measurements["scenes"][0]["bare"] = {bare(0.1, 0.01, 0.02), bare(1, 0.104, 0.2)};
    measurements["scenes"][1]["bare"] = {bare(0.1, 0.03, 0.0404), {{"distance_km", 1}, {"rows", 0}}};
    measurements["results"][0]["regions"]["aerial near"] = bare(1, 0.001, 0.002);
    measurements["results"][0]["regions"]["aerial far"] = bare(1, 0.003, 0.004);
    for (const auto& [name, ms] : {std::pair{"composite_ms", 1.0},
                                   {"composite_geometry_ms", 1.2},
                                   {"composite_bare_ms", 0.9},
                                   {"aerial_perspective_ms", 0.1}})
        measurements["costs"][0][name] = {{"median", ms}};
    const std::vector<ClassSummary> classes = summaries(measurements);
    CHECK(classes[0].bare.at(0.1).median == doctest::Approx(0.02));
    CHECK(classes[0].bare.at(0.1).p95 == 0.0404);
    CHECK(classes[0].bare.at(1).p95 == 0.2);
    CHECK(classes[1].bare.empty());
    // A frame of 1.5 ms has 0.5 of tables; over geometry it takes 1.7, without the air 0.4 + 0.9.
    REQUIRE(classes[0].settings[0].without_air);
    CHECK(classes[0].settings[0].without_air->amount == doctest::Approx(0.4));
    CHECK(*classes[0].settings[0].without_air->share == doctest::Approx(0.4 / 1.7));
    CHECK_FALSE(classes[0].settings[1].without_air);
    const std::string tables = markdown_tables(measurements);
    CHECK(contains(tables, "| 0.1 † | 2 / 4 | – |"));
    CHECK(contains(tables, "| 1 | 10.4 / 20 | – |"));
    CHECK(contains(tables, "\n† Not measured there: brought nearer from the pixels at 1 to 3 km"));
    CHECK(contains(tables, "| hillaire default | 0.2 / 0.4 | – |"));
    CHECK(contains(tables, "| hillaire default | 0.4 | 24 % |"));
    measurements["scenes"][0]["bare"] = json::array({bare(1, 0.104, 0.2)});  // no nearer than the pixels
    measurements["scenes"][1].erase("bare");
    CHECK_FALSE(contains(markdown_tables(measurements), "†"));
    measurements["scenes"][0]["bare"][0]["distance_km"] = -1;
    CHECK(contains(complaint([&] { (void)markdown_tables(measurements, "m.json"); }),
                   "m.json: scenes[0].bare[0].distance_km: -1"));
}

TEST_CASE("report: parts that were not measured are said to be missing") {
    json measurements = example();
    measurements.erase("costs");
    measurements.erase("pictures");
    for (json& result : measurements["results"]) result.erase("split");
    const std::string tables = markdown_tables(measurements);
    CHECK(contains(tables, "Costs: not measured."));
    CHECK(contains(tables, "What the errors are made of was not measured."));
    CHECK(cell(lines_of(csv_lines(measurements)), 1, "per_frame_ms").empty());
    for (json& result : measurements["results"]) result["delta_e"] = json{{"rows", 0}};
    measurements["settings"][3]["baseline"] = "aureole high, of which nothing is known";
    measurements.erase("library");
    const std::string less = markdown_tables(measurements);
    CHECK(contains(less, "Suite `example`. Errors"));
    CHECK(contains(less, "| aureole default | 0.3 | 1.6 | 4 | – | – | 0.6 | – | 0.28 |"));
    CHECK_FALSE(contains(less, "simplification costs and saves"));
    measurements["results"] = json::array();
    CHECK(contains(markdown_tables(measurements), "## Mars\n\n1 scene.\n\nNot measured.\n"));
}

TEST_CASE("report: a line for each result") {
    const std::vector<std::string> lines = lines_of(csv_lines(example()));
    REQUIRE(lines.size() == 12);
    CHECK(cell(lines, 2, "scene") == "earth/sun60/2m");
    CHECK(cell(lines, 2, "sun_elevation_deg") == "60");
    CHECK(cell(lines, 4, "setting") == "aureole default, no ozone");
    CHECK(cell(lines, 4, "without") == "ozone");
    CHECK(cell(lines, 4, "baseline") == "aureole default");
    CHECK(cell(lines, 2, "horizon_p95") == "0.012");
    CHECK(cell(lines, 2, "nadir_rows") == "0");
    CHECK(cell(lines, 2, "nadir_max").empty());
    CHECK(cell(lines, 2, "discretisation_max") == "0.006");
    CHECK(cell(lines, 2, "delta_e_p95") == "0.12");
    CHECK(cell(lines, 2, "banding_delta_e") == "0.2");
    CHECK(cell(lines, 2, "rebuild_medium_evaluations") == "1600000");
    CHECK(cell(lines, 10, "per_frame_ms") == "1");  // on Mars
}

TEST_CASE("report: faults are named by file and field") {
    CHECK(after([](json&) {}) == "nothing");
    CHECK(after([](json& m) { m = json::array(); }) == "m.json: the whole: [] is not allowed; allowed: an object");
    CHECK(after([](json& m) { m["version"] = 2; }) == "m.json: version: 2 is not allowed; allowed: 1");
    CHECK(after([](json& m) { m.erase("scenes"); }) == "m.json: scenes: is missing");
    CHECK(after([](json& m) { m["scenes"][1]["sun_elevation_deg"] = 91; }) ==
          "m.json: scenes[1].sun_elevation_deg: 91 is not allowed; allowed: -90 to 90 degrees");
    CHECK(contains(after([](json& m) { m["scenes"][1]["id"] = "mars/sun10/2m"; }), "m.json: scenes[2].id: \"mars/sun10/2m\""));
    CHECK(contains(after([](json& m) { m["settings"][3]["baseline"] = 3; }), "m.json: settings[3].baseline: 3"));
    CHECK(contains(after([](json& m) { m["settings"][1]["baseline"] = "aureole default"; }), "m.json: settings[1].baseline:"));
    CHECK(contains(after([](json& m) { m["settings"][3]["without"] = "ozone"; }), "m.json: settings[3].without"));
    CHECK(contains(after([](json& m) { m["results"][4]["scene"] = "venus"; }), "m.json: results[4].scene: \"venus\""));
    CHECK(after([](json& m) { m["results"][4]["regions"].erase("all"); }) == "m.json: results[4].regions.all: is missing");
    CHECK(contains(after([](json& m) { m["results"][4]["regions"]["zenith"]["p95"] = -1; }),
                   "m.json: results[4].regions.zenith.p95: -1 is not allowed"));
    CHECK(contains(after([](json& m) { m["results"][4]["regions"]["zenith"]["median"] = 0.9; }),
                   "allowed: median <= p95 <= max"));
    CHECK(contains(after([](json& m) { m["results"][4]["luminance_rmse"] = "small"; }), "m.json: results[4].luminance_rmse"));
    CHECK(
        contains(after([](json& m) { m["results"].push_back(m["results"][0]); }), "allowed: each setting once in each scene"));
    CHECK(contains(after([](json& m) { m["costs"][0]["air"] = "venus"; }), "m.json: costs[0].air: \"venus\""));
    CHECK(contains(after([](json& m) { m["costs"][0]["bytes"] = nullptr; }), "m.json: costs[0].bytes: null"));
    CHECK(contains(after([](json& m) { m["costs"].push_back(m["costs"][0]); }), "allowed: each setting once in each air"));
    CHECK(contains(after([](json& m) { m["pictures"][0]["png"] = "\"onload="; }), "m.json: pictures[0].png"));
}

TEST_CASE("report: the page holds the data, and nothing in the data can leave its place") {
    json measurements = example();
    measurements["suite"] = "</script><script>alert(1)</script>";
    if (page_before_data.empty()) {
        CHECK(contains(complaint([&] { write_report(measurements, "none.html"); }), "built without"));
        CHECK_FALSE(std::filesystem::exists("none.html"));
        return;
    }
    write_report(measurements, "report.html");
    const std::string page = get("report.html");
    CHECK(page.starts_with(std::string(page_before_data)));
    CHECK(page.ends_with(std::string(page_after_data)));
    const std::string data =
        page.substr(page_before_data.size(), page.size() - page_before_data.size() - page_after_data.size());
    CHECK_FALSE(contains(data, "<"));
    const json read = json::parse(data);
    CHECK(read["suite"] == measurements["suite"]);
    CHECK(read["classes"][0]["settings"][1]["regions"]["all"]["median"].get<double>() == doctest::Approx(0.003));
    measurements["version"] = 2;
    CHECK(contains(complaint([&] { write_report(measurements, "bad.html", "bad.json"); }), "bad.json: version"));
    CHECK_FALSE(std::filesystem::exists("bad.html"));
}
