#include "app/score.h"

#include "app/quantile.h"
#include "app/row_error.h"
#include "io/csv.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace aureole::app {
namespace {

constexpr std::array<std::string_view, 7> result_columns{
    "sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg", "r", "g", "b"};
constexpr std::array<std::string_view, 10> truth_columns{
    "sun_zenith_deg", "altitude_km", "view_zenith_deg", "azimuth_deg",     "L_r_per_sr",
    "L_g_per_sr",     "L_b_per_sr",  "stderr_r_per_sr", "stderr_g_per_sr", "stderr_b_per_sr"};

using Place = std::array<double, 4>;

Place place_of(const CsvTable& table, std::size_t row) {
    return {table.columns[0][row], table.columns[1][row], table.columns[2][row], table.columns[3][row]};
}
Channels color_of(const CsvTable& table, std::size_t row, std::size_t first) {
    return {table.columns[first][row], table.columns[first + 1][row], table.columns[first + 2][row]};
}

bool meets_ground(const Place& place, double bottom_radius_km) {
    const double r = bottom_radius_km + std::max(place[1], 0.0), zenith = place[2] * std::numbers::pi / 180;
    return std::cos(zenith) < 0 && r * std::sin(zenith) < bottom_radius_km;
}

double radius_from(const CsvTable& truth, const std::string& file) {
    constexpr std::string_view key = "bottom_radius_km=";
    for (const std::string& comment : truth.comments) {
        const std::size_t at = comment.find(key);
        double radius = 0;
        if (at != std::string::npos &&
            std::from_chars(comment.data() + at + key.size(), comment.data() + comment.size(), radius).ec == std::errc() &&
            radius > 0)
            return radius;
    }
    throw Error(ErrorCode::invalid_argument, file + ": no comment line says bottom_radius_km=...; give --bottom-radius-km");
}

}  // namespace

std::vector<ScoreLine> score(const std::filesystem::path& result_path, const std::filesystem::path& truth_path,
                             const ScoreOptions& options) {
    const CsvTable result = read_csv(result_path, result_columns), truth = read_csv(truth_path, truth_columns);
    std::map<Place, std::size_t> found;
    for (std::size_t i = 0; i < result.rows(); ++i) found.emplace(place_of(result, i), i);
    const double radius = !options.by_ray                ? 0
                          : options.bottom_radius_km > 0 ? options.bottom_radius_km
                                                         : radius_from(truth, truth_path.string());

    struct Group {
        ScoreLine line;
        std::vector<double> errors;
    };
    std::map<std::tuple<double, double, std::string>, Group> groups;
    for (std::size_t i = 0; i < truth.rows(); ++i) {
        const Place place = place_of(truth, i);
        const auto match = found.find(place);
        if (match == found.end())
            throw Error(ErrorCode::invalid_argument, result_path.string() + " has no row for line " +
                                                         std::to_string(truth.lines[i]) + " of " + truth_path.string());
        const std::string ray = !options.by_ray ? "" : meets_ground(place, radius) ? "ground" : "sky";
        Group& group = groups[{place[0], options.by_altitude ? place[1] : 0, ray}];
        group.line.sun_zenith_deg = place[0];
        group.line.altitude_km = place[1];
        group.line.ray = ray;
        const std::optional<double> error =
            row_error(color_of(result, match->second, 4), color_of(truth, i, 4), color_of(truth, i, 7));
        if (!error) {
            ++group.line.skipped;
            continue;
        }
        group.errors.push_back(*error);
        if (group.errors.size() == 1 || *error > group.line.worst) {
            group.line.worst = *error;
            group.line.worst_line = truth.lines[i];
        }
    }

    std::vector<ScoreLine> lines;
    for (auto& [key, group] : groups) {
        std::ranges::sort(group.errors);
        group.line.rows = group.errors.size();
        group.line.median = quantile(group.errors, 0.5);
        group.line.p95 = quantile(group.errors, 0.95);
        lines.push_back(group.line);
    }
    return lines;
}

}  // namespace aureole::app
