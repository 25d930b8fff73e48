// The application's figures are those of the tables of docs/accuracy.md: `aureole probe` and `aureole score`, against the
// errors measured here.
#include "accuracy/measure.h"

#include "app/probe.h"
#include "app/score.h"
#include "io/csv.h"
#include "io/file.h"
#include "physics/truth.h"
#include "scratch_folder.h"

#include <doctest/doctest.h>

#include <array>

using namespace aureole;

namespace {

constexpr std::array<std::string_view, 4> places{"sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg"};

std::vector<app::ProbeRow> rows_of(const std::filesystem::path& file) {
    const app::CsvTable table = app::read_csv(file, places);
    std::vector<app::ProbeRow> rows;
    for (std::size_t i = 0; i < table.rows(); ++i)
        rows.push_back({table.columns[0][i], table.columns[1][i], table.columns[2][i], table.columns[3][i]});
    return rows;
}

}  // namespace

TEST_CASE("aureole probe and aureole score give the figures of the accuracy tests") {
    const std::filesystem::path truth = physics::truth_file("earth.csv");
    const ModelPtr model = model_by_name("aureole", "low");
    const auto backend = app::open_backend({.name = "cpu"});
    const std::vector<app::ProbeRow> rows = rows_of(truth);
    const ScratchFolder folder;
    app::write_text(folder.path() / "result.csv",
                    app::print_rows("", rows, app::probe(*backend, presets::earth(), model, rows)));

    auto measured = physics::measure("earth.csv", presets::earth(), model);
    const std::vector<app::ScoreLine> scored = app::score(folder.path() / "result.csv", truth, {});
    REQUIRE(scored.size() == measured.size());
    std::size_t skipped = 0;
    for (const app::ScoreLine& line : scored) {
        CAPTURE(line.sun_zenith_deg);
        physics::Errors& errors = measured.at(line.sun_zenith_deg);
        CHECK(line.rows == errors.percent.size());
        CHECK(100 * line.median == doctest::Approx(errors.quantile(0.5)).scale(1e-300).epsilon(1e-4));
        CHECK(100 * line.p95 == doctest::Approx(errors.quantile(0.95)).scale(1e-300).epsilon(1e-4));
        CHECK(100 * line.worst == doctest::Approx(errors.quantile(1)).scale(1e-300).epsilon(1e-4));
        skipped += line.skipped;
    }
    CHECK(skipped > 0);  // rays from space into space
}
