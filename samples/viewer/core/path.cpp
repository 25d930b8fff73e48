#include "viewer/core/path.h"

#include "io/csv.h"
#include "io/file.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>

namespace aureole::viewer {
namespace {

struct Column {
    std::string_view name;
    double PathPoint::*value;
    bool bearing = false;
};
constexpr std::array<Column, 7> columns{{{"time_s", &PathPoint::time_s},
                                         {"altitude_m", &PathPoint::altitude_m},
                                         {"east_m", &PathPoint::east_m},
                                         {"north_m", &PathPoint::north_m},
                                         {"bearing_deg", &PathPoint::bearing_deg, true},
                                         {"elevation_deg", &PathPoint::elevation_deg},
                                         {"vertical_fov_deg", &PathPoint::vertical_fov_deg}}};

/// The first line that is no comment: the names of the columns.
std::string header_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line) && (line.empty() || line.front() == '#')) {
    }
    return line;
}

/// "sun_2_bearing_deg" and "sun_2_elevation_deg".
std::array<std::string, 2> sun_columns(std::size_t sun) {
    const std::string begin = "sun_" + std::to_string(sun + 1);
    return {begin + "_bearing_deg", begin + "_elevation_deg"};
}

/// Names of all columns of a path with so many suns.
std::vector<std::string> names_of(std::size_t suns) {
    std::vector<std::string> names;
    names.reserve(std::size(columns) + 2 * suns);
    for (const Column& column : columns) names.emplace_back(column.name);
    for (std::size_t sun = 0; sun < suns; ++sun)
        for (std::string& name : sun_columns(sun)) names.push_back(std::move(name));
    return names;
}

std::vector<double> row_of(const PathPoint& point) {
    std::vector<double> row;
    row.reserve(std::size(columns) + 2 * point.suns.size());
    for (const Column& column : columns) row.push_back(point.*column.value);
    for (const app::ScenePose& sun : point.suns) row.insert(row.end(), {sun.bearing_deg, sun.elevation_deg});
    return row;
}

template <class Cells, class Print>
void add_line(std::string& text, const Cells& cells, Print print) {
    for (std::size_t c = 0; c < cells.size(); ++c) text.append(c == 0 ? "" : ",").append(print(cells[c]));
    text += '\n';
}

double between(double from, double to, double t, bool bearing) {
    return from + t * (bearing ? std::remainder(to - from, 360.0) : to - from);
}

}  // namespace

PathPoint point_of(const app::Scene& scene, double altitude_m, double time_s) {
    PathPoint point;
    point.time_s = time_s;
    point.altitude_m = altitude_m;
    if (scene.terrain) {
        point.east_m = scene.terrain->camera_east_m;
        point.north_m = scene.terrain->camera_north_m;
    }
    point.bearing_deg = scene.camera.pose.bearing_deg;
    point.elevation_deg = scene.camera.pose.elevation_deg;
    point.vertical_fov_deg = scene.camera.vertical_fov_deg;
    for (const app::SceneSun& sun : scene.suns) point.suns.push_back(sun.pose);
    return point;
}

void stand_at(app::Scene& scene, const PathPoint& point) {
    scene.camera.clearance_m.reset();
    scene.camera.altitude_m = point.altitude_m;
    scene.camera.pose = {point.bearing_deg, point.elevation_deg};
    scene.camera.vertical_fov_deg = point.vertical_fov_deg;
    if (scene.terrain) {
        scene.terrain->camera_east_m = point.east_m;
        scene.terrain->camera_north_m = point.north_m;
    }
    for (std::size_t i = 0; i < std::min(scene.suns.size(), point.suns.size()); ++i) scene.suns[i].pose = point.suns[i];
}

void Path::add(const PathPoint& point) {
    while (!points_.empty() && points_.back().time_s >= point.time_s) points_.pop_back();
    points_.push_back(point);
    if (points_.size() == 1) return;
    const std::vector<app::ScenePose>& before = std::prev(points_.end(), 2)->suns;
    std::vector<app::ScenePose>& suns = points_.back().suns;
    const std::size_t has = suns.size();
    suns.resize(before.size());
    for (std::size_t i = has; i < before.size(); ++i) suns[i] = before[i];
}

PathPoint Path::at(double time_s) const {
    const auto after = std::ranges::upper_bound(points_, time_s, {}, &PathPoint::time_s);
    if (after == points_.begin()) return points_.front();
    if (after == points_.end()) return points_.back();
    const PathPoint &from = *std::prev(after), &to = *after;
    const double t = (time_s - from.time_s) / (to.time_s - from.time_s);
    PathPoint point;
    for (const Column& column : columns) point.*column.value = between(from.*column.value, to.*column.value, t, column.bearing);
    for (std::size_t i = 0; i < from.suns.size(); ++i)
        point.suns.push_back({between(from.suns[i].bearing_deg, to.suns[i].bearing_deg, t, true),
                              between(from.suns[i].elevation_deg, to.suns[i].elevation_deg, t, false)});
    return point;
}

void write_path(const std::filesystem::path& file, const Path& path) {
    std::string text = "# A path of aureole-viewer: metres, degrees, seconds.\n";
    add_line(text, names_of(path.points().empty() ? 0 : path.points().front().suns.size()), std::identity());
    for (const PathPoint& point : path.points())
        add_line(text, row_of(point), [](double value) { return app::print_number(value); });
    app::write_text(file, text);
}

Path read_path(const std::filesystem::path& file) {
    const std::string text = app::read_text(file);
    const std::string header = header_of(text);
    std::size_t suns = 0;
    while (header.find(sun_columns(suns)[0]) != std::string::npos) ++suns;
    const std::vector<std::string> names = names_of(suns);
    const std::vector<std::string_view> views(names.begin(), names.end());
    const app::CsvTable table = app::parse_csv(text, file.string(), views);
    Path path;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        PathPoint point;
        for (std::size_t c = 0; c < columns.size(); ++c) point.*columns[c].value = table.columns[c][row];
        for (std::size_t c = columns.size(); c < names.size(); c += 2)
            point.suns.push_back({table.columns[c][row], table.columns[c + 1][row]});
        if (row > 0 && point.time_s <= path.length_s())
            throw Error(ErrorCode::invalid_argument, file.string() + ":" + std::to_string(table.lines[row]) + ": time_s",
                        app::print_number(point.time_s), "more than that of the line before");
        path.add(point);
    }
    return path;
}

}  // namespace aureole::viewer
