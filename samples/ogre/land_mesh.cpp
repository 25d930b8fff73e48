#include "land_mesh.h"

#include "terrain/height_field.h"
#include "terrain/ray_caster.h"
#include "terrain/terrain.h"

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
    Rings(Ogre::ManualObject& object, const app::Scene& scene, const Axes& axes)
        : object_(object),
          terrain_(*scene.terrain),
          axes_(axes),
          anchor_(terrain_.camera_east_m, terrain_.camera_north_m),
          field_(app::read_height_map(terrain_.height_map, terrain_.options), terrain_.vertical_exaggeration),
          caster_(field_, scene.atmosphere.planet.bottom_radius_m, anchor_) {}

    void build() {
        vertex(anchor_, nearest_ring_m);
        std::uint32_t rings = 0;
        for (double radius = nearest_ring_m; radius < terrain_.range_m; radius *= growth, ++rings) ring(radius);
        for (std::uint32_t s = 0; s < sectors; ++s) object_.triangle(0, index(0, s), index(0, s + 1));
        for (std::uint32_t r = 0; r + 1 < rings; ++r)
            for (std::uint32_t s = 0; s < sectors; ++s)
                object_.quad(index(r, s), index(r + 1, s), index(r + 1, s + 1), index(r, s + 1));
    }
    [[nodiscard]] double ground() const { return field_.height(anchor_); }

private:
    static std::uint32_t index(std::uint32_t ring, std::uint32_t sector) { return 1 + ring * sectors + sector % sectors; }

    void ring(double radius) {
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const double angle = 2 * std::numbers::pi * s / sectors;
            vertex(anchor_ + radius * glm::dvec2(std::cos(angle), std::sin(angle)), radius * (growth - 1));
        }
    }

    void vertex(glm::dvec2 place, double spacing_m) {
        const double height = field_.height(place);
        const glm::dvec3 local = field_.normal(place), point = caster_.point_at(place, height);
        const Rgb albedo = terrain_.albedo.value_or(app::natural_albedo(place, height, local, spacing_m));
        object_.position(to_ogre(axes_.position(point)));
        object_.normal(to_ogre(Axes::direction(caster_.to_world(point, local))));
        // Not as a colour: OGRE keeps those in 8 bits.
        object_.textureCoord(static_cast<float>(albedo.r), static_cast<float>(albedo.g), static_cast<float>(albedo.b),
                             static_cast<float>(field_.open_sky(place)));
    }

    Ogre::ManualObject& object_;
    const app::SceneTerrain& terrain_;
    const Axes& axes_;
    const glm::dvec2 anchor_;
    const app::HeightField field_;
    const app::RayCaster caster_;
};

}  // namespace

LandMesh make_land(Ogre::SceneManager& manager, const app::Scene& scene, const Axes& axes) {
    Ogre::ManualObject* object = manager.createManualObject("land");
    object->begin("aureole/land", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    Rings rings(*object, scene, axes);
    rings.build();
    object->end();
    manager.getRootSceneNode()->createChildSceneNode()->attachObject(object);
    return {object, rings.ground()};
}

}  // namespace aureole::ogre
