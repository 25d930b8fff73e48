#include "host_vulkan/terrain_mesh.h"

#include "terrain/height_field.h"
#include "terrain/ray_caster.h"
#include "terrain/terrain.h"

#include <algorithm>
#include <cmath>

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

void add_quads(std::vector<std::uint32_t>& indices) {
    constexpr std::uint32_t points = 2 * half_side + 1;
    for (std::uint32_t y = 0; y + 1 < points; ++y)
        for (std::uint32_t x = 0; x + 1 < points; ++x) {
            const std::uint32_t corner = y * points + x;
            for (const std::uint32_t next : {0U, 1U, points, points, 1U, points + 1}) indices.push_back(corner + next);
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
    const HeightField field(read_height_map(terrain.height_map, terrain.options), terrain.vertical_exaggeration);
    const glm::dvec2 anchor(terrain.camera_east_m, terrain.camera_north_m);
    const RayCaster caster(field, radius, anchor);
    mesh.lowest_m = field.height(anchor);
    if (scene.camera.clearance_m) mesh.camera_altitude_m = mesh.lowest_m + *scene.camera.clearance_m;
    mesh.origin_m.z = radius + mesh.camera_altitude_m;

    const double range = std::min(terrain.range_m, horizon_m(radius, mesh.camera_altitude_m, field.highest()));
    const Lines lines(field.cell_size(0).x, range);
    for (std::uint32_t y = 0; y <= 2 * half_side; ++y)
        for (std::uint32_t x = 0; x <= 2 * half_side; ++x) {
            const glm::dvec2 place = anchor + glm::dvec2(lines.at(x), lines.at(y));
            const double height = field.height(place), spacing = std::max(lines.spacing(x), lines.spacing(y));
            const glm::dvec3 point = caster.point_at(place, height), normal = field.normal(place);
            const aureole::Rgb albedo = terrain.albedo.value_or(natural_albedo(place, height, normal, spacing));
            mesh.vertices.push_back({glm::vec3(point - mesh.origin_m), glm::vec3(caster.to_world(point, normal)),
                                     glm::vec4(glm::vec3(albedo), static_cast<float>(field.open_sky(place)))});
        }
    add_quads(mesh.indices);
    return mesh;
}

}  // namespace host_vulkan
