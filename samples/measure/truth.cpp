#include "measure/truth.h"

#include "app/fnv.h"
#include "io/csv.h"
#include "io/file.h"
#include "measure/points.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

namespace aureole::app {
namespace {

struct Kind {
    std::string_view suffix, title;
    std::array<std::string_view, 11> columns;
};
constexpr std::array<Kind, 4> kinds{
    Kind{".csv",
         "truth by path tracing, 1/sr per unit of solar irradiance, the sun's disk excluded: ",
         {"sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg", "L_r_per_sr", "L_g_per_sr", "L_b_per_sr",
          "stderr_r_per_sr", "stderr_g_per_sr", "stderr_b_per_sr", "paths"}},
    Kind{"_aerial.csv",
         "truth by path tracing of pixels that show geometry through the air, 1/sr per unit of solar irradiance: ",
         {"sun_zenith_deg", "altitude_km", "pixel", "azimuth_deg", "L_r_per_sr", "L_g_per_sr", "L_b_per_sr", "stderr_r_per_sr",
          "stderr_g_per_sr", "stderr_b_per_sr", "paths"}},
    Kind{"_picture.csv",
         "truth by path tracing of the pixels of pictures, 1/sr per unit of solar irradiance, the sun's disk excluded: ",
         {"sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg", "L_r_per_sr", "L_g_per_sr", "L_b_per_sr",
          "stderr_r_per_sr", "stderr_g_per_sr", "stderr_b_per_sr", "paths"}},
    Kind{"_light.csv",
         "truth by path tracing, irradiance per unit of the sun's, part 0 of the sky on a horizontal surface, 1 of the sun: ",
         {"sun_zenith_deg", "altitude_km", "part", "azimuth_deg", "E_r", "E_g", "E_b", "stderr_r", "stderr_g", "stderr_b",
          "paths"}}};
const Kind& of(TruthKind kind) { return kinds[static_cast<std::size_t>(kind)]; }

constexpr double aerial_azimuth_deg = 60;
constexpr int value_digits = 7, error_digits = 3;

std::array<double, 4> place_of(const ProbeRow& row) {
    return {row.sun_zenith_deg, row.altitude_km, row.view_zenith_deg, row.azimuth_deg};
}

std::string comment(TruthKind kind, TraceParameters parameters) {
    if (kind == TruthKind::aerial)
        for (auto& parameter : aerial_parameters()) parameters.push_back(std::move(parameter));
    return std::string(of(kind).title) + print_parameters(parameters);
}

/// Where a line of parameters ends in "name=number": that number, which is cut off.
std::optional<int> cut_off(std::string& line, std::string_view name) {
    const std::size_t space = line.rfind(' ');
    if (space == std::string::npos || line.compare(space + 1, name.size() + 1, std::string(name) + "=") != 0) return {};
    int value = 0;
    const char* const end = line.data() + line.size();
    const auto [rest, error] = std::from_chars(line.data() + space + name.size() + 2, end, value);
    if (error != std::errc() || rest != end) return {};
    line.resize(space);
    return value;
}
TruthMadeBy cut_off_made_by(std::string& line) {
    TruthMadeBy made_by;
    made_by.version = cut_off(line, "version");
    made_by.seed = cut_off(line, "seed");
    return made_by;
}
std::string print(const TruthMadeBy& made_by) {
    return (made_by.seed ? " seed=" + std::to_string(*made_by.seed) : "") +
           (made_by.version ? " version=" + std::to_string(*made_by.version) : "");
}

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

TruthTable TruthTable::read(const std::filesystem::path& path, const TraceParameters& parameters, TruthKind kind) {
    TruthTable result(kind);
    if (!std::filesystem::exists(path)) return result;
    const CsvTable table = read_csv(path, of(kind).columns);
    std::string line = table.comments.empty() ? "" : table.comments.front();
    result.made_by_ = cut_off_made_by(line);
    compare(path, line, comment(kind, parameters));
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto at = [&](std::size_t column) { return table.columns[column][i]; };
        for (const std::size_t column : {std::size_t{7}, std::size_t{8}, std::size_t{9}, std::size_t{10}})
            if (!(at(column) >= 0 && at(column) <= 1e15))
                throw Error(ErrorCode::invalid_argument,
                            path.string() + ":" + std::to_string(table.lines[i]) + ": " + std::string(of(kind).columns[column]),
                            print_number(at(column)), "in [0, 1e15]");
        result.entries_[{at(0), at(1), at(2), at(3)}] = {{{at(4), at(5), at(6)}, {at(7), at(8), at(9)}},
                                                         static_cast<std::uint64_t>(at(10))};
    }
    return result;
}

void TruthTable::check_may_grow(const std::filesystem::path& path, const TruthMadeBy& today) const {
    const auto check = [&](const char* name, int there, int here) {
        if (there == here) return;
        throw Error(ErrorCode::invalid_argument, path.string() + ": " + name, std::to_string(there),
                    std::to_string(here) + "; remove the file, and `aureole truth` makes it anew");
    };
    const auto seed = [](const TruthMadeBy& by) { return by.seed.value_or(TruthMadeBy::first_seed); };
    const auto version = [](const TruthMadeBy& by) { return by.version.value_or(TruthMadeBy::first_version); };
    check("seed", seed(made_by_), seed(today));
    check("version", version(made_by_), version(today));
}

void TruthTable::write(const std::filesystem::path& path, const TraceParameters& parameters) const {
    std::string text = "# " + comment(kind_, parameters) + print(made_by_) + "\n";
    for (const std::string_view column : of(kind_).columns) text.append(column).append(column == "paths" ? "\n" : ",");
    for (const auto& [place, entry] : entries_) {
        for (const double value : place) text.append(print_number(value)).append(",");
        for (int c = 0; c < 3; ++c) text.append(print_number(entry.value.value[c], value_digits)).append(",");
        for (int c = 0; c < 3; ++c) text.append(print_number(entry.value.error[c], error_digits)).append(",");
        text.append(std::to_string(entry.paths)).append("\n");
    }
    write_text(path, text);
}

const TruthTable::Entry* TruthTable::find(const ProbeRow& row) const {
    const auto found = entries_.find(place_of(row));
    return found == entries_.end() ? nullptr : &found->second;
}

void TruthTable::set(const ProbeRow& row, const Entry& entry) { entries_[place_of(row)] = entry; }

std::vector<ProbeRow> TruthTable::missing(std::span<const ProbeRow> rows, const Wanted& wanted) const {
    constexpr double rounding = 1.05;  // errors are written with two digits
    std::vector<ProbeRow> result;
    for (const ProbeRow& row : rows) {
        const Entry* known = find(row);
        const bool enough =
            known != nullptr && (known->paths + trace_round_paths > wanted.paths ||
                                 relative_error(Estimated{known->value.value, known->value.error}) <= rounding * wanted.error);
        if (!enough) result.push_back(row);
    }
    return result;
}

AirTruth read_truth(const Suite& suite, std::size_t air) {
    const TraceParameters parameters = truth_parameters(suite.airs[air]);
    const auto table = [&](TruthKind kind) {
        return TruthTable::read(truth_file(suite, suite.airs[air], kind), parameters, kind);
    };
    return {table(TruthKind::sky), table(TruthKind::aerial), table(TruthKind::light)};
}

std::uint64_t fingerprint(std::span<const TrueValue> values) {
    Fnv1a hash;
    for (const TrueValue& value : values)
        for (const Rgb& part : {value.value, value.error})
            for (int c = 0; c < 3; ++c) hash.add(std::bit_cast<std::uint64_t>(part[c]));
    return hash.value();
}

std::filesystem::path truth_file(const Suite& suite, const SuiteAir& air, TruthKind kind) {
    return suite.truth_folder / (air.name + std::string(of(kind).suffix));
}

TraceParameters truth_parameters(const SuiteAir& air) {
    TraceParameters parameters = describe(air.parameters);
    parameters.emplace_back("spectral", air.spectral);
    return parameters;
}

std::vector<TruthRows> truth_rows(const Suite& suite, std::size_t air) {
    std::vector<TruthRows> all;
    for (const std::size_t i : suite.scenes_of(air)) {
        const SuiteScene& scene = suite.scenes[i];
        auto alike = std::ranges::find_if(
            all, [&](const TruthRows& of) { return of.error == scene.truth_error && of.max_paths == scene.truth_max_paths; });
        if (alike == all.end()) alike = all.insert(all.end(), {scene.truth_error, scene.truth_max_paths, {}});
        for (const Point& point : points_of(suite.airs[air].parameters.planet, scene.sun_zenith_deg(), scene.altitude_km()))
            alike->rows.push_back(point.row);
    }
    const auto less = [](const ProbeRow& a, const ProbeRow& b) { return place_of(a) < place_of(b); };
    const auto same = [](const ProbeRow& a, const ProbeRow& b) { return place_of(a) == place_of(b); };
    for (TruthRows& of : all) {
        std::ranges::sort(of.rows, less);
        of.rows.erase(std::unique(of.rows.begin(), of.rows.end(), same), of.rows.end());
    }
    return all;
}

AerialView aerial_view(const SuiteScene& scene) { return {scene.sun_zenith_deg(), scene.altitude_km(), aerial_azimuth_deg}; }
ProbeRow aerial_row(const AerialView& view, std::size_t pixel) {
    return {view.sun_zenith_deg, view.altitude_km, static_cast<double>(pixel), view.azimuth_deg};
}
ProbeRow light_row(const SuiteScene& scene, LightPart part) {
    return {scene.sun_zenith_deg(), scene.altitude_km(), static_cast<double>(part), 0};
}

}  // namespace aureole::app
