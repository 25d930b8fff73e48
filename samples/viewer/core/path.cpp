#include "viewer/core/path.h"

#include "io/csv.h"
#include "io/file.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aureole::viewer {
namespace {

struct Column {
    std::string_view name;
    double PathPoint::*value;
    bool bearing = false;
};
constexpr std::array<Column, 9> columns{{{"time_s", &PathPoint::time_s},
                                         {"altitude_m", &PathPoint::altitude_m},
                                         {"east_m", &PathPoint::east_m},
                                         {"north_m", &PathPoint::north_m},
                                         {"bearing_deg", &PathPoint::bearing_deg, true},
                                         {"elevation_deg", &PathPoint::elevation_deg},
                                         {"vertical_fov_deg", &PathPoint::vertical_fov_deg},
                                         {"sun_bearing_deg", &PathPoint::sun_bearing_deg, true},
                                         {"sun_elevation_deg", &PathPoint::sun_elevation_deg}}};

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
    if (scene.suns.empty()) return point;
    point.sun_bearing_deg = scene.suns.front().pose.bearing_deg;
    point.sun_elevation_deg = scene.suns.front().pose.elevation_deg;
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
    if (!scene.suns.empty()) scene.suns.front().pose = {point.sun_bearing_deg, point.sun_elevation_deg};
}

void Path::add(const PathPoint& point) {
    while (!points_.empty() && points_.back().time_s >= point.time_s) points_.pop_back();
    points_.push_back(point);
}

PathPoint Path::at(double time_s) const {
    const auto after = std::ranges::upper_bound(points_, time_s, {}, &PathPoint::time_s);
    if (after == points_.begin()) return points_.front();
    if (after == points_.end()) return points_.back();
    const PathPoint &from = *std::prev(after), &to = *after;
    const double t = (time_s - from.time_s) / (to.time_s - from.time_s);
    PathPoint point;
    for (const Column& column : columns) {
        double way = to.*column.value - from.*column.value;
        if (column.bearing) way = std::remainder(way, 360.0);
        point.*column.value = from.*column.value + t * way;
    }
    return point;
}

void write_path(const std::filesystem::path& file, const Path& path) {
    std::string text = "# A path of aureole-viewer: metres, degrees, seconds.\n";
    for (const Column& column : columns) text.append(column.name).append(&column == &columns.back() ? "\n" : ",");
    for (const PathPoint& point : path.points())
        for (const Column& column : columns)
            text.append(app::print_number(point.*column.value)).append(&column == &columns.back() ? "\n" : ",");
    app::write_text(file, text);
}

Path read_path(const std::filesystem::path& file) {
    std::array<std::string_view, columns.size()> names;
    std::ranges::transform(columns, names.begin(), &Column::name);
    const app::CsvTable table = app::read_csv(file, names);
    Path path;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        PathPoint point;
        for (std::size_t c = 0; c < columns.size(); ++c) point.*columns[c].value = table.columns[c][row];
        if (row > 0 && point.time_s <= path.length_s())
            throw Error(ErrorCode::invalid_argument, file.string() + ":" + std::to_string(table.lines[row]) + ": time_s",
                        app::print_number(point.time_s), "more than that of the line before");
        path.add(point);
    }
    return path;
}

}  // namespace aureole::viewer
