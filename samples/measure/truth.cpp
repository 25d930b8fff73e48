#include "measure/truth.h"

#include "io/csv.h"
#include "io/file.h"
#include "measure/points.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>

namespace aureole::app {
namespace {

constexpr std::array<std::string_view, 11> columns{
    "sun_zenith_deg", "altitude_km",     "view_zenith_deg", "azimuth_deg",     "L_r_per_sr", "L_g_per_sr",
    "L_b_per_sr",     "stderr_r_per_sr", "stderr_g_per_sr", "stderr_b_per_sr", "paths"};
constexpr std::string_view title = "truth by path tracing, 1/sr per unit of solar irradiance, the sun's disk excluded: ";
constexpr int value_digits = 7, error_digits = 3;

std::array<double, 4> place_of(const ProbeRow& row) {
    return {row.sun_zenith_deg, row.altitude_km, row.view_zenith_deg, row.azimuth_deg};
}

std::string comment(const TraceParameters& parameters) { return std::string(title) + print_parameters(parameters); }

/// Says which of the names and values is another one.
void compare(const std::filesystem::path& path, const std::string& there, const std::string& here) {
    if (there == here) return;
    const auto [a, b] = std::ranges::mismatch(there, here);
    const auto word = [](const std::string& text, auto at) {
        const std::size_t start = text.rfind(' ', static_cast<std::size_t>(at - text.begin())) + 1;
        return text.substr(start, text.find(' ', start) - start);
    };
    throw Error(ErrorCode::invalid_argument, path.string() + " is the truth of another air: \"" + word(there, a) +
                                                 "\" there, \"" + word(here, b) +
                                                 "\" here; remove it, and `aureole truth` makes it anew");
}

}  // namespace

TruthTable TruthTable::read(const std::filesystem::path& path, const TraceParameters& parameters) {
    TruthTable result;
    if (!std::filesystem::exists(path)) return result;
    const CsvTable table = read_csv(path, columns);
    compare(path, table.comments.empty() ? "" : table.comments.front(), comment(parameters));
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto at = [&](std::size_t column) { return table.columns[column][i]; };
        result.entries_[{at(0), at(1), at(2), at(3)}] = {{{at(4), at(5), at(6)}, {at(7), at(8), at(9)}},
                                                         static_cast<std::uint64_t>(at(10))};
    }
    return result;
}

void TruthTable::write(const std::filesystem::path& path, const TraceParameters& parameters) const {
    std::string text = "# " + comment(parameters) + "\n";
    for (const std::string_view column : columns) text.append(column).append(column == columns.back() ? "\n" : ",");
    for (const auto& [place, entry] : entries_) {
        for (const double value : place) text.append(print_number(value)).append(",");
        for (int c = 0; c < 3; ++c) text.append(print_number(entry.radiance.value[c], value_digits)).append(",");
        for (int c = 0; c < 3; ++c) text.append(print_number(entry.radiance.error[c], error_digits)).append(",");
        text.append(std::to_string(entry.paths)).append("\n");
    }
    write_text(path, text);
}

const TruthTable::Entry* TruthTable::find(const ProbeRow& row) const {
    const auto found = entries_.find(place_of(row));
    return found == entries_.end() ? nullptr : &found->second;
}

void TruthTable::set(const ProbeRow& row, const Entry& entry) { entries_[place_of(row)] = entry; }

std::vector<ProbeRow> TruthTable::missing(std::span<const ProbeRow> rows) const {
    std::vector<ProbeRow> result;
    for (const ProbeRow& row : rows)
        if (!find(row)) result.push_back(row);
    return result;
}

std::filesystem::path truth_file(const Suite& suite, const SuiteAir& air) { return suite.truth_folder / (air.name + ".csv"); }

TraceParameters truth_parameters(const SuiteAir& air) {
    TraceParameters parameters = describe(air.parameters);
    parameters.emplace_back("spectral", air.spectral);
    return parameters;
}

std::vector<ProbeRow> truth_rows(const Suite& suite, std::size_t air) {
    std::vector<ProbeRow> rows;
    for (const std::size_t i : suite.scenes_of(air)) {
        const SuiteScene& scene = suite.scenes[i];
        for (const Point& point : points_of(suite.airs[air].parameters.planet, scene.sun_zenith_deg(), scene.altitude_km()))
            rows.push_back(point.row);
    }
    const auto less = [](const ProbeRow& a, const ProbeRow& b) { return place_of(a) < place_of(b); };
    const auto same = [](const ProbeRow& a, const ProbeRow& b) { return place_of(a) == place_of(b); };
    std::ranges::sort(rows, less);
    const auto repeated = std::ranges::unique(rows, same);
    rows.erase(repeated.begin(), repeated.end());
    return rows;
}

}  // namespace aureole::app
