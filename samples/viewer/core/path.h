// A path: where camera and first sun were, from moment to moment. Recorded while flying, kept as a CSV file, and flown again.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace aureole::viewer {

struct PathPoint {
    double time_s = 0;
    double altitude_m = 0, east_m = 0, north_m = 0;
    double bearing_deg = 0, elevation_deg = 0, vertical_fov_deg = 60;
    double sun_bearing_deg = 0, sun_elevation_deg = 0;
    [[nodiscard]] bool operator==(const PathPoint&) const = default;
};

/// Of a scene at a moment; `altitude_m` of its camera above the ground radius.
[[nodiscard]] PathPoint point_of(const app::Scene& scene, double altitude_m, double time_s);
/// The scene's camera and first sun (where it has one) as the point has them.
void stand_at(app::Scene& scene, const PathPoint& point);

class Path {
public:
    /// Times must rise; a point that is not later than the last one takes its place.
    void add(const PathPoint& point);
    [[nodiscard]] const std::vector<PathPoint>& points() const { return points_; }
    [[nodiscard]] double length_s() const { return points_.empty() ? 0 : points_.back().time_s; }
    /// Linear between points (bearings the shorter way round), constant beyond them. Not of an empty path.
    [[nodiscard]] PathPoint at(double time_s) const;

private:
    std::vector<PathPoint> points_;
};

/// Numbers are written in full: what is read is what was written. Throws Error: io, invalid_argument.
void write_path(const std::filesystem::path& file, const Path& path);
[[nodiscard]] Path read_path(const std::filesystem::path& file);

}  // namespace aureole::viewer
