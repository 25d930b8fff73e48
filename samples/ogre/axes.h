// From the axes of scenes (scene.h: origin at the planet's centre, +x north, +y west, +z up at the camera) to OGRE's, which are
// in float: origin on the ground below the camera, +x east, +y up, +z south.
#pragma once

#include <OgreVector.h>

#include <glm/vec3.hpp>

namespace aureole::ogre {

class Axes {
public:
    explicit Axes(double planet_radius_m) : radius_(planet_radius_m) {}

    [[nodiscard]] static glm::dvec3 direction(const glm::dvec3& in_scene) { return {-in_scene.y, in_scene.z, -in_scene.x}; }
    /// In double: differences from the planet's radius are taken before anything is rounded.
    [[nodiscard]] glm::dvec3 position(const glm::dvec3& in_scene) const {
        return direction(in_scene) - glm::dvec3(0, radius_, 0);
    }
    /// Back: a place along OGRE's axes as a point along the scene's, from the planet's centre.
    [[nodiscard]] glm::dvec3 to_scene(const glm::dvec3& in_ogre) const { return {-in_ogre.z, -in_ogre.x, in_ogre.y + radius_}; }
    /// From the planet's centre, along OGRE's axes: what Aureole wants to know of a camera.
    [[nodiscard]] glm::dvec3 from_centre(const Ogre::Vector3& in_ogre) const {
        return {in_ogre.x, radius_ + static_cast<double>(in_ogre.y), in_ogre.z};
    }

private:
    double radius_;
};

[[nodiscard]] inline Ogre::Vector3 to_ogre(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace aureole::ogre
