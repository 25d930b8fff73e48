// Aureole in the engine: its sky and air over the engine's picture, and the engine's light from its tables.
#pragma once

#include "axes.h"
#include "engine.h"
#include "gl_guest.h"
#include "scene/scene.h"

#include <aureole/atmosphere.h>

#include <memory>
#include <vector>

namespace aureole::ogre {

/// The engine's camera as Aureole takes it: in double, with the depth that land.frag writes.
[[nodiscard]] Camera camera_of(const Ogre::Camera& camera, const Axes& axes);
/// Near distance of that depth, metres; land.frag knows it, too.
inline constexpr double depth_near_m = 1;

/// Of the sample's view, on every device; its other settings are app::view_settings, of a picture with land.
[[nodiscard]] CompositeSettings composite_settings(const app::Scene& scene);

class Sky {
public:
    /// In the engine's context. Both, and the scene, outlive the sky.
    Sky(Engine& engine, const app::Scene& scene);
    ~Sky();
    Sky(const Sky&) = delete;
    Sky& operator=(const Sky&) = delete;

    /// Before the engine draws: camera and suns of this frame (in OGRE's axes), and the light that the frame before has left.
    void update(const Camera& camera, std::span<const Sun> suns);
    /// After the engine has drawn its scene: tables that have changed, and the picture.
    void draw();

    /// Milliseconds of the device's clock that the latest draw() took; not a number where it does not tell.
    [[nodiscard]] double milliseconds() const;

private:
    [[nodiscard]] rhi::Texture lend(const Ogre::TexturePtr& texture, rhi::Format format, rhi::Usage usage);
    void light_the_engine(const Sun& sun);
    [[nodiscard]] bool timed() const;

    Engine& engine_;
    std::unique_ptr<gl::Guest> guest_;
    Atmosphere air_;
    View view_;
    CompositeTargets targets_;
    rhi::Buffer light_;
    std::vector<float> light_texels_;
    bool light_read_ = false;
};

}  // namespace aureole::ogre
