#include "app/cost_scene.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double camera_altitude_m = 500;
constexpr double shadowed_m = 16000;                      // across the map
constexpr std::uint32_t shadow_texels = 256, stripe = 8;  // 500 m of shade
constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;

rhi::Format target_format(const PassCostOptions& options) {
    return options.linear ? rhi::Format::rgba16_float : rhi::Format::rgba8_unorm;
}

}  // namespace

CompositeSettings cost_composite(const PassCostOptions& options, bool geometry) {
    CompositeSettings settings;
    settings.target_format = target_format(options);
    settings.raster = options.raster;
    settings.scene_color = settings.scene_depth = geometry;
    if (options.linear) return settings;
    settings.exposure = 10;
    settings.tone_map = ToneMap::aces_fitted;
    settings.encode_srgb = settings.dither = true;
    return settings;
}

Camera cost_camera(const Planet& planet, const PassCostOptions& options) {
    return look(planet.bottom_radius_m, camera_altitude_m, 0, 0, 60 * degree,
                static_cast<double>(options.width) / options.height);
}

CostTextures::CostTextures(Backend& backend, const PassCostOptions& options) : own_(backend) {
    const rhi::Extent extent{options.width, options.height, 1};
    const rhi::Usage written = options.raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
    plain_.extent = geometry_.extent = extent;
    plain_.target = geometry_.target =
        own_.create("picture", target_format(options), extent, written | rhi::Usage::copy_source);
    own_.make_ready(plain_.target, options.raster ? rhi::State::color_attachment : rhi::State::storage_write);
    make_scene(options);
    make_shadow_map();
}

void CostTextures::make_scene(const PassCostOptions& options) {
    const rhi::Extent extent = geometry_.extent;
    geometry_.scene_color = own_.create("scene colour", rhi::Format::rgba16_float, extent, given);
    geometry_.scene_depth = own_.create("scene depth", rhi::Format::d32_float, extent, given);
    std::vector<float> depth(std::size_t{options.width} * options.height);
    const Camera camera = cost_camera({}, options);  // of any planet: the matrix alone
    for (std::uint32_t y = 0; y < options.height; ++y) {
        const double down = ((y + 0.5) / options.height * 2 - 1) / camera.projection[1][1];
        const double view_depth = down > 0.005 ? camera_altitude_m / down : down > -0.1 ? 20000 : INFINITY;
        for (std::uint32_t x = 0; x < options.width; ++x)
            depth[std::size_t{y} * options.width + x] = static_cast<float>(camera.projection[3][2] / view_depth);
    }
    const std::vector<std::uint16_t> color(depth.size() * 4, 0x2000);  // 2^-7 in half floats
    own_.upload(geometry_.scene_color, std::as_bytes(std::span(color)), rhi::State::undefined, rhi::State::sampled);
    own_.upload(geometry_.scene_depth, std::as_bytes(std::span(depth)), rhi::State::undefined, rhi::State::depth_read);
}

void CostTextures::make_shadow_map() {
    const rhi::Extent extent{shadow_texels, shadow_texels, 1};
    shadow_map_ = own_.create("shadow map", rhi::Format::r32_float, extent, given);
    std::vector<float> depth(std::size_t{shadow_texels} * shadow_texels);
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = i % shadow_texels / stripe % 2 == 0 ? 0.0F : 1.0F;
    own_.upload(shadow_map_, std::as_bytes(std::span(depth)), rhi::State::undefined, rhi::State::sampled);
}

ShadowMap CostTextures::shadow_map(const Planet& planet) const {
    ShadowMap map;
    map.texture = shadow_map_;
    // The camera is on the z axis; depth is that below it, and all of it is between 0 and 1.
    glm::dmat4& to_map = map.world_to_map[0];
    to_map = glm::dmat4(0);
    to_map[0][0] = to_map[1][1] = 1 / shadowed_m;
    to_map[2][2] = -1 / shadowed_m;
    to_map[3] = {0.5, 0.5, 0.5 + planet.bottom_radius_m / shadowed_m, 1};
    return map;
}

}  // namespace aureole::app
