#include "app/land.h"

#include "app/pass_times.h"
#include "io/csv.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace aureole::app {
namespace {

std::vector<LightRow> read_light(Backend& backend, const View& view, std::size_t suns, std::size_t max_suns) {
    const LightTable table = DeviceTextures(backend).read_light(view, max_suns);
    std::vector<LightRow> rows(suns);
    for (int s = 0; s < static_cast<int>(suns); ++s) {
        LightRow& row = rows[static_cast<std::size_t>(s)];
        for (int i = 0; i < LightTable::coefficient_count; ++i)
            row.sky[static_cast<std::size_t>(i)] = table.sky_coefficient(i, s);
        row.sun = table.sun_irradiance(s);
    }
    return rows;
}

/// The height map, or an error that says who named it: the scene, or whoever overrode the scene.
HeightMap read_map(const SceneTerrain& terrain, const std::filesystem::path& height_map) {
    try {
        return read_height_map(height_map, terrain.options);
    } catch (const Error& problem) {
        const std::string who = height_map == terrain.height_map ? terrain.height_map_key : "--heightmap";
        throw Error(problem.code(), who + ": " + problem.what());
    }
}

}  // namespace

Land::Land(const Scene& scene, const std::filesystem::path& height_map)
    : field_(std::make_unique<HeightField>(read_map(*scene.terrain, height_map), scene.terrain->vertical_exaggeration)) {
    follow(scene);
}

void Land::follow(const Scene& scene) {
    const SceneTerrain& terrain = *scene.terrain;
    const glm::dvec2 anchor(terrain.camera_east_m, terrain.camera_north_m);
    const double ground = field_->height(anchor);
    const double altitude = scene.camera.clearance_m ? ground + *scene.camera.clearance_m : scene.camera.altitude_m;
    if (altitude < ground)
        throw Error(ErrorCode::invalid_argument, "camera.altitude_m", print_number(altitude),
                    "at least " + print_number(ground) + ", the height of the land there");
    bottom_radius_m_ = scene.atmosphere.planet.bottom_radius_m;
    caster_ = std::make_unique<RayCaster>(*field_, bottom_radius_m_, anchor);
    look_ = {terrain.albedo, terrain.range_m};
    camera_altitude_m_ = altitude;
    ground_m_ = ground;
}

TerrainLight Land::measure_light(Backend& backend, Atmosphere& air, const std::vector<Sun>& suns) const {
    ViewSettings settings;
    settings.max_suns = static_cast<std::uint32_t>(std::max<std::size_t>(suns.size(), 1));
    settings.aerial_perspective = false;
    TerrainLight light;
    light.low_m = field_->lowest();
    light.high_m = std::max(field_->highest(), light.low_m + 1);
    for (const Sun& sun : suns) light.sun_directions.push_back(glm::normalize(sun.direction));
    View view(air, settings);
    for (auto [height, rows] : {std::pair(light.low_m, &light.low), std::pair(light.high_m, &light.high)}) {
        view.update(look(bottom_radius_m_, height, 0, 0, 1, 1), suns);
        backend.run([&](rhi::CommandList& commands) {
            air.record(commands);
            view.record(commands);
        });
        *rows = read_light(backend, view, suns.size(), settings.max_suns);
    }
    return light;
}

TerrainPicture Land::cast(const Camera& camera, const TerrainLight& light, std::uint32_t width, std::uint32_t height) const {
    return cast_terrain(*field_, *caster_, camera, light, look_, width, height);
}

}  // namespace aureole::app
