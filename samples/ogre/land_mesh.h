// The height field as a mesh of OGRE's: rings around the camera's place, the wider the farther, on the curved planet.
#pragma once

#include "axes.h"
#include "scene/scene.h"
#include "terrain/land_vertices.h"

#include <OgreSceneManager.h>

#include <glm/vec3.hpp>

#include <memory>

namespace aureole::ogre {

struct LandMesh {
    Ogre::ManualObject* object;
    std::unique_ptr<app::LandVertices> land;  ///< The field that it was made of.
};

/// `scene` has terrain. Throws Error where its height map cannot be read.
[[nodiscard]] LandMesh make_land(Ogre::SceneManager& manager, const app::Scene& scene, const Axes& axes);

}  // namespace aureole::ogre
