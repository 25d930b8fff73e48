#include "sky.h"

#include "common/scene_settings.h"

#include <aureole/light.h>

#include <OgreCamera.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace aureole::ogre {
namespace {

Ogre::ColourValue colour(const Rgb& rgb) {
    return Ogre::ColourValue(static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b));
}

}  // namespace

Camera camera_of(const Ogre::Camera& camera, const Axes& axes) {
    const Ogre::Quaternion& q = camera.getRealOrientation();
    const glm::dquat turn = glm::normalize(glm::dquat(q.w, q.x, q.y, q.z));
    const Ogre::Matrix4& projection = camera.getProjectionMatrix();
    Camera made;
    made.position_m = axes.from_centre(camera.getRealPosition());
    made.view = glm::dmat4(glm::transpose(glm::mat3_cast(turn)));
    made.projection = glm::dmat4(0);
    for (int column = 0; column < 3; ++column) {  // x and y are the engine's, depth is land.frag's
        made.projection[column][0] = static_cast<double>(projection[0][column]);
        made.projection[column][1] = static_cast<double>(projection[1][column]);
    }
    made.projection[2][3] = -1;
    made.projection[3][2] = depth_near_m;
    // OGRE turns its projection over when it draws into a texture of OpenGL's, so that row 0 is the top, as on other systems.
    made.row_order = RowOrder::top_first;
    return made;
}

CompositeSettings composite_settings(const app::Scene& scene) {
    CompositeSettings settings = app::composite_settings(scene, true);
    settings.target_format = rhi::Format::rgba16_float;
    return settings;
}

Sky::Sky(Engine& engine, const app::Scene& scene)
    : engine_(engine),
      guest_(gl::borrow_context()),
      air_(guest_->device(), scene.atmosphere, scene.model.make()),
      view_(air_, app::view_settings(scene, true), composite_settings(scene)),
      light_texels_(LightTable::floats_per_sun * app::view_settings(scene, true).max_suns) {
    targets_.scene_color = lend(engine.colour(), rhi::Format::rgba16_float, rhi::Usage::sampled);
    targets_.scene_depth = lend(engine.depth(), rhi::Format::r32_float, rhi::Usage::sampled);
    targets_.target = lend(engine.picture(), rhi::Format::rgba16_float, rhi::Usage::sampled | rhi::Usage::storage);
    targets_.extent = {engine.picture()->getWidth(), engine.picture()->getHeight(), 1};
    view_.prepare_composite(targets_);
    light_ = guest_->device().create_buffer({"light", sizeof(float) * light_texels_.size(), rhi::Usage::read_back});
}

Sky::~Sky() {
    rhi::Device& device = guest_->device();
    view_.release_composite(targets_);
    for (const rhi::Texture texture : {targets_.scene_color, targets_.scene_depth, targets_.target}) device.destroy(texture, 0);
    device.destroy(light_, 0);
}

rhi::Texture Sky::lend(const Ogre::TexturePtr& texture, rhi::Format format, rhi::Usage usage) {
    rhi::ExternalTexture external;
    external.desc = {texture->getName(), rhi::Dimension::d2, format, {texture->getWidth(), texture->getHeight(), 1}, usage};
    external.native = texture->getCustomAttribute("GLID");
    external.state = rhi::State::sampled;
    return guest_->device().wrap_texture(external);
}

void Sky::update(const Camera& camera, std::span<const Sun> suns) {
    view_.update(camera, suns);
    if (light_read_ && !suns.empty()) light_the_engine(suns.front());
}

/// The first sun is the engine's directional light; the sky of all of them its ambient light.
void Sky::light_the_engine(const Sun& sun) {
    guest_->device().read_buffer(light_, std::as_writable_bytes(std::span(light_texels_)));
    const LightTable light(light_texels_);
    const Rgb direct = light.sun_irradiance(0), sky = light.sky_irradiance({0, 1, 0});
    engine_.set_light(to_ogre(glm::normalize(sun.direction)), colour(direct), colour(sky));
}

void Sky::draw() {
    const rhi::TextureBarrier open[] = {{targets_.target, rhi::State::sampled, rhi::State::storage_write},
                                        {view_.light_table(), rhi::State::sampled, rhi::State::copy_source}};
    const rhi::TextureBarrier close[] = {{targets_.target, rhi::State::storage_write, rhi::State::sampled},
                                         {view_.light_table(), rhi::State::copy_source, rhi::State::sampled}};
    const rhi::BufferBarrier fill{light_, rhi::State::undefined, rhi::State::copy_destination};
    rhi::CommandList& list = guest_->begin_recording();
    if (timed()) list.timestamp(0);
    air_.record(list);
    view_.record(list);
    list.barrier(open, {&fill, 1});
    view_.record_composite(list, targets_);
    list.copy(rhi::TextureToBuffer{view_.light_table(), light_});
    list.barrier(close, {});
    if (timed()) list.timestamp(1);
    guest_->end_recording();
    light_read_ = true;
}

bool Sky::timed() const { return guest_->device().capabilities().timestamp_slots >= 2; }

double Sky::milliseconds() const {
    if (!timed()) return std::nan("");
    double times[2] = {};
    guest_->device().read_timestamps(times);
    return (times[1] - times[0]) * 1e-6;
}

}  // namespace aureole::ogre
