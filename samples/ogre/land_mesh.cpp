#include "land_mesh.h"

#include <OgreManualObject.h>

#include <cmath>
#include <numbers>

namespace aureole::ogre {
namespace {

constexpr std::uint32_t sectors = 512;
constexpr double nearest_ring_m = 20;
constexpr double growth = 1 + 2 * std::numbers::pi / sectors;  // quads are square

class Rings {
public:
    Rings(Ogre::ManualObject& object, const app::LandVertices& land, double range_m, const Axes& axes)
        : object_(object), land_(land), range_(range_m), axes_(axes) {}

    void build() {
        vertex({0, 0}, nearest_ring_m);
        std::uint32_t rings = 0;
        for (double radius = nearest_ring_m; radius < range_; radius *= growth, ++rings) ring(radius);
        for (std::uint32_t s = 0; s < sectors; ++s) object_.triangle(0, index(0, s), index(0, s + 1));
        for (std::uint32_t r = 0; r + 1 < rings; ++r)
            for (std::uint32_t s = 0; s < sectors; ++s)
                object_.quad(index(r, s), index(r + 1, s), index(r + 1, s + 1), index(r, s + 1));
    }

private:
    static std::uint32_t index(std::uint32_t ring, std::uint32_t sector) { return 1 + ring * sectors + sector % sectors; }

    void ring(double radius) {
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const double angle = 2 * std::numbers::pi * s / sectors;
            vertex(radius * glm::dvec2(std::cos(angle), std::sin(angle)), radius * (growth - 1));
        }
    }

    void vertex(glm::dvec2 offset, double spacing_m) {
        const app::LandVertex made = land_.at(offset, spacing_m);
        object_.position(to_ogre(axes_.position(made.point)));
        object_.normal(to_ogre(Axes::direction(made.normal)));
        // Not as a colour: OGRE keeps those in 8 bits.
        object_.textureCoord(static_cast<float>(made.albedo.r), static_cast<float>(made.albedo.g),
                             static_cast<float>(made.albedo.b), static_cast<float>(made.open_sky));
    }

    Ogre::ManualObject& object_;
    const app::LandVertices& land_;
    double range_;
    const Axes& axes_;
};

}  // namespace

LandMesh make_land(Ogre::SceneManager& manager, const app::Scene& scene, const Axes& axes) {
    Ogre::ManualObject* object = manager.createManualObject("land");
    object->begin("aureole/land", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    auto land = std::make_unique<app::LandVertices>(scene);
    Rings(*object, *land, scene.terrain->range_m, axes).build();
    object->end();
    manager.getRootSceneNode()->createChildSceneNode()->attachObject(object);
    return {object, std::move(land)};
}

}  // namespace aureole::ogre
