// The land around the camera as triangles: fine where it is near.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace host_vulkan {

struct Vertex {
    glm::vec3 position;  ///< From TerrainMesh::origin_m, world axes, metres.
    glm::vec3 normal;
    glm::vec4 albedo;  ///< w: share of the sky that the land around leaves free.
};

struct TerrainMesh {
    glm::dvec3 origin_m{0};      ///< From the planet's centre.
    double camera_altitude_m{};  ///< Of the scene's camera, above the ground radius.
    double lowest_m{};           ///< Ground at the camera.
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Empty where the scene has no terrain. Throws Error as reading the height map does.
[[nodiscard]] TerrainMesh make_terrain(const aureole::app::Scene& scene);

}  // namespace host_vulkan
