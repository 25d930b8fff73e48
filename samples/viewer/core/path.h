// A path: where camera and suns were, from moment to moment. Recorded while flying, kept as a CSV file, and flown again.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace aureole::viewer {

struct PathPoint {
    double time_s = 0;
    double altitude_m = 0, east_m = 0, north_m = 0;
    double bearing_deg = 0, elevation_deg = 0, vertical_fov_deg = 60;
    std::vector<app::ScenePose> suns;
    [[nodiscard]] bool operator==(const PathPoint&) const = default;
};

/// Of a scene at a moment; `altitude_m` of its camera above the ground radius.
[[nodiscard]] PathPoint point_of(const app::Scene& scene, double altitude_m, double time_s);
/// The scene's camera and suns as the point has them; suns that only one of the two has stay where they are.
void stand_at(app::Scene& scene, const PathPoint& point);

class Path {
public:
    /// Times must rise; a point that is not later than the last one takes its place. A path has as many suns as its first
    /// point: of a later one that lacks some, they stay where they were; those that it has besides are left out.
    void add(const PathPoint& point);
    [[nodiscard]] const std::vector<PathPoint>& points() const { return points_; }
    [[nodiscard]] double length_s() const { return points_.empty() ? 0 : points_.back().time_s; }
    /// Linear between points (bearings the shorter way round), constant beyond them. Not of an empty path.
    [[nodiscard]] PathPoint at(double time_s) const;

private:
    std::vector<PathPoint> points_;
};

/// Numbers are written in full: what is read is what was written. Suns have a pair of columns each, as many as the header
/// names: sun_1_bearing_deg, sun_1_elevation_deg, sun_2_... Throws Error: io, invalid_argument.
void write_path(const std::filesystem::path& file, const Path& path);
[[nodiscard]] Path read_path(const std::filesystem::path& file);

}  // namespace aureole::viewer
