#include "terrain/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace aureole::app {

/// A ray and what is asked about its points.
struct RayCaster::Line {
    const RayCaster& caster;
    glm::dvec3 origin, direction;
    double perigee;  // where it is closest to the planet's centre

    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
    [[nodiscard]] double altitude(double t) const { return caster.altitude_of(at(t)); }
    /// Altitude is convex along a line: its minimum on an interval is at the perigee or at an end.
    [[nodiscard]] double lowest(double from, double to) const { return altitude(std::clamp(perigee, from, to)); }
    /// Above the land.
    [[nodiscard]] double clearance(double t) const {
        const glm::dvec3 p = at(t);
        return caster.altitude_of(p) - caster.field_.height(caster.place_of(p));
    }
};

RayCaster::RayCaster(const HeightField& field, double planet_radius_m, glm::dvec2 anchor)
    : field_(field), radius_(planet_radius_m), anchor_(anchor) {}

double RayCaster::altitude_of(const glm::dvec3& point) const { return glm::length(point) - radius_; }

glm::dvec2 RayCaster::place_of(const glm::dvec3& point) const {
    const double squared = point.x * point.x + point.y * point.y;
    if (squared == 0) return anchor_;
    // arc / across = radius * atan(across / z) / across. Within a few degrees of the anchor, where all the land of a picture
    // is, five terms of the series leave an error below a micrometre.
    const double q = squared / (point.z * point.z);
    if (point.z > 0 && q < 0.002)
        return anchor_ + glm::dvec2(-point.y, point.x) *
                             (radius_ / point.z * (1 - q * (1.0 / 3 - q * (1.0 / 5 - q * (1.0 / 7 - q * (1.0 / 9))))));
    const double across = std::sqrt(squared);
    return anchor_ + glm::dvec2(-point.y, point.x) * (radius_ * std::atan2(across, point.z) / across);
}

glm::dvec3 RayCaster::point_at(glm::dvec2 place, double height_m) const {
    const glm::dvec2 offset = place - anchor_;
    const double arc = glm::length(offset), angle = arc / radius_;
    const glm::dvec2 along = arc > 0 ? offset / arc : glm::dvec2(0);
    return (radius_ + height_m) * glm::dvec3(along.y * std::sin(angle), -along.x * std::sin(angle), std::cos(angle));
}

glm::dvec3 RayCaster::to_world(const glm::dvec3& point, const glm::dvec3& local) const {
    const glm::dvec3 up = glm::normalize(point);
    // North at the anchor, made horizontal: within the 2 degrees of a picture's land the difference to the map's north is nil.
    const glm::dvec3 north = glm::normalize(glm::dvec3(1, 0, 0) - up * up.x);
    const glm::dvec3 east = glm::cross(north, up);
    return local.x * east + local.y * north + local.z * up;
}

std::optional<RayCaster::Hit> RayCaster::cast(const glm::dvec3& origin, const glm::dvec3& direction, double from_m,
                                              double to_m) const {
    const Line line{*this, origin, direction, -glm::dot(origin, direction)};
    // Only the part of the ray below the highest summit matters.
    const double summit = radius_ + field_.highest() + 1e-3;
    const double reach = summit * summit - glm::dot(origin, origin) + line.perigee * line.perigee;
    if (reach <= 0) return std::nullopt;
    double t = std::max(from_m, line.perigee - std::sqrt(reach));
    const double end = std::min(to_m, line.perigee + std::sqrt(reach));

    int level = field_.levels() - 1;
    double known_at = -1, known = 0;  // the latest clearance that was computed
    while (t < end) {
        const glm::dvec3 p = line.at(t);
        const glm::dvec2 cells = (place_of(p) - field_.origin()) / field_.cell_size(level);
        const std::int64_t x = static_cast<std::int64_t>(std::floor(cells.x)),
                           y = static_cast<std::int64_t>(std::floor(cells.y));

        // How far to the cell's edge, with the map's axes taken as straight over one cell.
        const glm::dvec3 up = glm::normalize(p);
        const glm::dvec3 north = glm::normalize(glm::dvec3(1, 0, 0) - up * up.x);
        const glm::dvec2 speed(glm::dot(direction, glm::cross(north, up)), glm::dot(direction, north));
        const glm::dvec2 inside = cells - glm::floor(cells);
        double step = 1e30;
        for (int axis = 0; axis < 2; ++axis) {
            const double left = speed[axis] > 0 ? 1 - inside[axis] : inside[axis];
            if (std::abs(speed[axis]) > 1e-12)
                step = std::min(step, left * field_.cell_size(level)[axis] / std::abs(speed[axis]));
        }
        // A little into the next cell, so that the march goes on; at least as far as double precision can tell.
        const double next = std::min(t + step + 0.01 * field_.cell_size(0).x, end);

        if (line.lowest(t, next) > field_.ceiling(level, x, y)) {
            t = next;
            level = std::min(level + 1, field_.levels() - 1);
        } else if (level > 0) {
            --level;
        } else {
            if (known_at != t) known = line.clearance(t);
            if (known <= 0) return Hit{t, place_of(line.at(t))};
            known = line.clearance(next);
            known_at = next;
            if (known <= 0) return refine(line, t, next);
            t = next;
        }
    }
    return std::nullopt;
}

std::optional<RayCaster::Hit> RayCaster::refine(const Line& line, double above_m, double below_m) const {
    for (int i = 0; i < 40 && below_m - above_m > 1e-4; ++i) {
        const double middle = 0.5 * (above_m + below_m);
        (line.clearance(middle) > 0 ? above_m : below_m) = middle;
    }
    return Hit{below_m, place_of(line.at(below_m))};
}

}  // namespace aureole::app
