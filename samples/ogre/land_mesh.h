// The height field as a mesh of OGRE's: rings around the camera's place, the wider the farther, on the curved planet.
#pragma once

#include "axes.h"
#include "scene/scene.h"

#include <OgreSceneManager.h>

#include <glm/vec3.hpp>

namespace aureole::ogre {

struct LandMesh {
    Ogre::ManualObject* object;
    double ground_m;  ///< Height of the land below the camera's place.
};

/// `scene` has terrain. Throws Error where its height map cannot be read.
[[nodiscard]] LandMesh make_land(Ogre::SceneManager& manager, const app::Scene& scene, const Axes& axes);

}  // namespace aureole::ogre
