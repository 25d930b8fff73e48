// Land ray-cast on the CPU into what a host hands to the composite: linear colour and depth.
#pragma once

#include "terrain/height_field.h"
#include "terrain/ray_caster.h"

#include <aureole/camera.h>
#include <aureole/parameters.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace aureole::app {

/// One sun's light at a height: the row of View::light_table.
struct LightRow {
    std::array<Rgb, 9> sky;  ///< SH-L2 coefficients of the sky's radiance, world axes.
    Rgb sun;                 ///< Irradiance of a surface that faces the sun.
};

/// The light that the land gets, from the tables of two views: rows of all suns at each height, linear in between.
struct TerrainLight {
    double low_m = 0, high_m = 1;
    std::vector<LightRow> low, high;
    std::vector<glm::dvec3> sun_directions;  ///< Unit, world axes.
};

struct TerrainLook {
    std::optional<Rgb> albedo;  ///< None: fields, forest and rock by slope and altitude.
    double range_m = 250e3;
};

/// A host's buffers: rows from the top. Sky pixels have colour 0 and depth 0, infinity in a reversed depth buffer.
struct TerrainPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;
    std::vector<float> depth;
    double covered = 0;  ///< Share of pixels that show land.
    double nearest_m = 0, farthest_m = 0;
};

/// Sees the field from a camera made by aureole::look (perspective, reversed infinite depth), on all processor cores.
[[nodiscard]] TerrainPicture cast_terrain(const HeightField& field, const RayCaster& caster, const Camera& camera,
                                          const TerrainLight& light, const TerrainLook& look, std::uint32_t width,
                                          std::uint32_t height);

/// Diffuse albedo of a natural surface: `normal` in (east, north, up), `footprint_m` the width of the pixel on the ground.
[[nodiscard]] Rgb natural_albedo(glm::dvec2 place, double height_m, const glm::dvec3& normal, double footprint_m);

}  // namespace aureole::app
