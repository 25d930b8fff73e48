#include "host_vulkan/terrain_mesh.h"

#include "terrain/land_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace host_vulkan {
namespace {

using namespace aureole::app;

constexpr std::uint32_t half_side = 160;  // quads from the middle to the edge

/// Places of grid lines: evenly spaced in the middle, as the height field's cells are, and ever wider outwards.
class Lines {
public:
    Lines(double finest_m, double range_m) : share_(std::min(finest_m * half_side / range_m, 1.0)), range_(range_m) {}
    [[nodiscard]] double at(std::uint32_t line) const {
        const double u = (static_cast<double>(line) - half_side) / half_side;
        return range_ * u * (share_ + (1 - share_) * std::abs(u * u * u));
    }
    /// Metres between a line and the next.
    [[nodiscard]] double spacing(std::uint32_t line) const {
        const double u = std::abs(static_cast<double>(line) - half_side) / half_side;
        return range_ / half_side * (share_ + 4 * (1 - share_) * u * u * u);
    }

private:
    double share_, range_;
};

/// How far the highest land can be seen from the camera.
double horizon_m(double radius_m, double camera_m, double highest_m) {
    const auto one = [&](double height) { return std::sqrt(std::max(height, 0.0) * (2 * radius_m + height)); };
    return one(camera_m) + one(highest_m);
}

/// Two triangles a quad, cut along the diagonal that climbs less: ridges and valleys then have no teeth.
void add_quads(TerrainMesh& mesh, std::span<const double> heights) {
    constexpr std::uint32_t points = 2 * half_side + 1;
    for (std::uint32_t y = 0; y + 1 < points; ++y)
        for (std::uint32_t x = 0; x + 1 < points; ++x) {
            const std::uint32_t a = y * points + x, b = a + 1, c = a + points, d = c + 1;
            if (std::abs(heights[a] - heights[d]) < std::abs(heights[b] - heights[c]))
                mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
            else
                mesh.indices.insert(mesh.indices.end(), {a, b, c, c, b, d});
        }
}

}  // namespace

TerrainMesh make_terrain(const Scene& scene) {
    const double radius = scene.atmosphere.planet.bottom_radius_m;
    TerrainMesh mesh;
    mesh.camera_altitude_m = scene.camera.altitude_m;
    mesh.origin_m = {0, 0, radius};
    if (!scene.terrain) return mesh;

    const SceneTerrain& terrain = *scene.terrain;
    const LandVertices land(scene);
    mesh.lowest_m = land.ground_m();
    if (scene.camera.clearance_m) mesh.camera_altitude_m = mesh.lowest_m + *scene.camera.clearance_m;
    mesh.origin_m.z = radius + mesh.camera_altitude_m;

    const double range = std::min(terrain.range_m, horizon_m(radius, mesh.camera_altitude_m, land.field().highest()));
    std::vector<double> heights;
    const Lines lines(land.field().cell_size(0).x, range);
    for (std::uint32_t y = 0; y <= 2 * half_side; ++y)
        for (std::uint32_t x = 0; x <= 2 * half_side; ++x) {
            const LandVertex vertex = land.at({lines.at(x), lines.at(y)}, std::max(lines.spacing(x), lines.spacing(y)));
            heights.push_back(glm::length(vertex.point) - radius);
            mesh.vertices.push_back({glm::vec3(vertex.point - mesh.origin_m), glm::vec3(vertex.normal),
                                     glm::vec4(glm::vec3(vertex.albedo), static_cast<float>(vertex.open_sky))});
        }
    add_quads(mesh, heights);
    return mesh;
}

}  // namespace host_vulkan
