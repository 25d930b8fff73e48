// OGRE, set up as a small game would: the scene into a half-float picture and its depth, then that picture, exposed, into the
// window. Between the two it calls whoever wants to work on them. It knows nothing of Aureole.
#pragma once

#include <OgreRenderTargetListener.h>
#include <OgreRoot.h>
#include <OgreTexture.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace aureole::ogre {

class Engine final : public Ogre::RenderTargetListener {
public:
    /// In the OpenGL context that is current, whose window has this size.
    Engine(std::uint32_t width, std::uint32_t height);
    ~Engine() override;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Scene-linear radiance of what is drawn (rgba16_float), its depth (r32_float), and what the window shows, exposed.
    [[nodiscard]] const Ogre::TexturePtr& colour() const noexcept { return colour_; }
    [[nodiscard]] const Ogre::TexturePtr& depth() const noexcept { return depth_; }
    [[nodiscard]] const Ogre::TexturePtr& picture() const noexcept { return picture_; }

    [[nodiscard]] Ogre::SceneManager& scene() noexcept { return *scene_; }
    [[nodiscard]] Ogre::Camera& camera() noexcept { return *camera_; }
    /// Takes the scene's light: its direction, irradiance of a surface that faces it, and of one that looks up to the sky.
    void set_light(const Ogre::Vector3& towards, const Ogre::ColourValue& sun, const Ogre::ColourValue& sky);
    [[nodiscard]] const Ogre::ColourValue& sun_colour() const;
    [[nodiscard]] const Ogre::ColourValue& sky_colour() const;
    void set_exposure(float exposure);
    /// Called in each frame once the scene has been drawn, before it is shown.
    void set_after_scene(std::function<void()> call) { after_scene_ = std::move(call); }

    void draw_frame();
    /// What the window shows, 8-bit RGB, rows from the top. Before buffers are swapped.
    [[nodiscard]] std::vector<std::uint8_t> read_window();
    /// Texels of a texture as RGBA, rows from the top.
    [[nodiscard]] static std::vector<float> read(const Ogre::TexturePtr& texture);

private:
    void start(std::uint32_t width, std::uint32_t height);
    void load_materials();
    [[nodiscard]] Ogre::TexturePtr make_texture(const char* name, Ogre::PixelFormat format, int usage) const;
    void make_scene_target();
    void make_show();
    void postRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override;

    std::unique_ptr<Ogre::Root> root_;
    Ogre::RenderWindow* window_ = nullptr;
    Ogre::SceneManager *scene_ = nullptr, *show_ = nullptr;
    Ogre::Camera *camera_ = nullptr, *show_camera_ = nullptr;
    Ogre::Light* sun_ = nullptr;
    Ogre::SceneNode* sun_node_ = nullptr;
    Ogre::TexturePtr colour_, depth_, picture_;
    std::function<void()> after_scene_;
};

}  // namespace aureole::ogre
