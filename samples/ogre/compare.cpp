#include "compare.h"

#include "common/scene_settings.h"
#include "sky.h"
#include "terrain/height_field.h"
#include "terrain/pixel_rays.h"
#include "terrain/ray_caster.h"

#include <aureole/cpu/cpu_device.h>
#include <aureole/light.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>

namespace aureole::ogre {
namespace {

// The picture is in half floats, and OpenGL leaves open how a device rounds to them: llvmpipe cuts off, by up to a step of
// 2^-10 (0.098 %); what is compared with is not rounded. The sky's tables are in float: there is nothing else. Where OGRE's
// camera, which is in float, turns a pixel's ray by 1e-6, the sky changes by less than is left.
constexpr double sky_bound = 1e-3;
// Before the land the air is in half floats, too, which one device cuts off and the other rounds, a step apart at most: of its
// radiance (0.098 %), and of optical depth t, of which a surface keeps t exp(-t), 0.37 at most (0.036 %). With the picture's
// step that is 0.232 % where all three meet.
constexpr double land_radiance_bound = 2.4e-3;
// A table in float, of tables in float.
constexpr double light_bound = 1e-5;
// The mesh is coarser than the field: its silhouettes may be off by some pixels' width, along lines.
constexpr double land_bound = 0.98;
// Squares of the mesh are 1.2 % of their distance wide, and seen at a grazing angle where the ground is flat.
constexpr double depth_bound = 0.03;
constexpr std::uint32_t probe_step = 4;  // every fourth pixel of every fourth row is probed

/// The scene's camera, with the depth that the engine's material writes.
Camera scene_camera(const app::Scene& scene, double altitude_m, rhi::Extent extent) {
    Camera camera = app::camera_of(scene, altitude_m, extent.width, extent.height);
    camera.projection[3][2] = depth_near_m;
    return camera;
}

/// What the CPU backend shows over the engine's colour and depth.
class Reference {
public:
    Reference(const app::Scene& scene, rhi::Extent extent)
        : extent_(extent),
          air_(device(), scene.atmosphere, scene.model.make()),
          view_(air_, app::view_settings(scene, true), composite(scene)) {}

    std::vector<float> picture(const Camera& camera, const std::vector<Sun>& suns, std::vector<float>& color,
                               std::vector<float>& depth) {
        std::vector<float> target(color.size());
        CompositeTargets targets;
        targets.extent = extent_;
        targets.scene_color = lend(color, rhi::Format::rgba32_float, rhi::Usage::sampled, rhi::State::sampled);
        targets.scene_depth = lend(depth, rhi::Format::r32_float, rhi::Usage::sampled, rhi::State::sampled);
        targets.target = lend(target, rhi::Format::rgba32_float, rhi::Usage::storage, rhi::State::storage_write);
        view_.prepare_composite(targets);
        view_.update(camera, suns);
        rhi::CommandList& list = cpu_->queue().begin();
        air_.record(list);
        view_.record(list);
        view_.record_composite(list, targets);
        cpu_->queue().submit();
        cpu_->queue().wait();
        return target;
    }
    /// Of the view that the picture shows.
    LightTable light() const {
        const std::vector<double> texels = cpu_->read_texels_double(view_.light_table());
        return LightTable(std::vector<float>(texels.begin(), texels.end()));
    }

private:
    static CompositeSettings composite(const app::Scene& scene) {
        CompositeSettings settings = composite_settings(scene);
        settings.target_format = rhi::Format::rgba32_float;
        return settings;
    }
    rhi::Device& device() { return cpu_->device(); }
    rhi::Texture lend(std::vector<float>& texels, rhi::Format format, rhi::Usage usage, rhi::State state) {
        rhi::ExternalTexture external;
        external.desc = {"engine's", rhi::Dimension::d2, format, extent_, usage};
        external.cpu_texels = texels.data();
        external.state = state;
        return device().wrap_texture(external);
    }

    rhi::Extent extent_;
    std::unique_ptr<cpu::CpuDevice> cpu_ = cpu::create_cpu_device({});
    Atmosphere air_;
    View view_;
};

/// Of pixels that show land, or of those that show the sky.
double radiance_error(const std::vector<float>& ours, const std::vector<float>& wanted, const std::vector<float>& depth,
                      bool land) {
    const float brightest = *std::max_element(wanted.begin(), wanted.end());
    double error = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (i % 4 == 3 || (depth[i / 4] > 0) != land) continue;  // alpha
        const double difference = std::abs(static_cast<double>(ours[i]) - static_cast<double>(wanted[i]));
        error = std::max(error, difference / std::max(static_cast<double>(wanted[i]), 1e-3 * static_cast<double>(brightest)));
    }
    return error;
}

double colour_error(const Ogre::ColourValue& colour, const Rgb& wanted) {
    const Rgb ours(static_cast<double>(colour.r), static_cast<double>(colour.g), static_cast<double>(colour.b));
    const Rgb apart = glm::abs(ours - wanted);
    return std::max({apart.r, apart.g, apart.b}) / std::max({wanted.r, wanted.g, wanted.b, 1e-12});
}

/// Rays of the scene's camera through the height field, against the depth of the engine's mesh.
void probe_land(const app::Scene& scene, const Camera& camera, const std::vector<float>& depth, rhi::Extent extent,
                Comparison& result) {
    const app::SceneTerrain& terrain = *scene.terrain;
    const app::HeightField field(app::read_height_map(terrain.height_map, terrain.options), terrain.vertical_exaggeration);
    const app::RayCaster caster(field, scene.atmosphere.planet.bottom_radius_m,
                                {terrain.camera_east_m, terrain.camera_north_m});
    const app::PixelRays rays(camera, extent.width, extent.height);
    std::vector<double> errors;
    std::size_t probed = 0, agreed = 0;
    for (std::uint32_t y = 0; y < extent.height; y += probe_step)
        for (std::uint32_t x = 0; x < extent.width; x += probe_step) {
            const glm::dvec3 in_view = rays.in_view(x, y);
            const auto hit = caster.cast(camera.position_m, rays.to_world * in_view, 0, terrain.range_m);
            const double drawn = static_cast<double>(depth[std::size_t{y} * extent.width + x]);
            ++probed;
            agreed += hit.has_value() == (drawn > 0);
            if (hit && drawn > 0)
                errors.push_back(std::abs(drawn / app::depth_value(camera.projection, -in_view.z * hit->distance_m) - 1));
        }
    result.land_agrees = static_cast<double>(agreed) / static_cast<double>(probed);
    if (errors.empty()) return;
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 9 / 10);
    std::nth_element(errors.begin(), place, errors.end());
    result.depth_error = *place;
}

}  // namespace

Comparison compare(const Engine& engine, const app::Scene& scene, double altitude_m) {
    const rhi::Extent extent{engine.picture()->getWidth(), engine.picture()->getHeight(), 1};
    const Camera camera = scene_camera(scene, altitude_m, extent);
    std::vector<float> color = Engine::read(engine.colour()), depth;
    const std::vector<float> four = Engine::read(engine.depth());
    for (std::size_t i = 0; i < four.size(); i += 4) depth.push_back(four[i]);

    Comparison result;
    const auto sky = std::count(depth.begin(), depth.end(), 0.0F);
    result.sky_share = static_cast<double>(sky) / static_cast<double>(depth.size());
    probe_land(scene, camera, depth, extent, result);
    Reference reference(scene, extent);
    const std::vector<float> wanted = reference.picture(camera, app::suns_of(scene), color, depth);
    const std::vector<float> shown = Engine::read(engine.picture());
    result.sky_error = radiance_error(shown, wanted, depth, false);
    result.land_error = radiance_error(shown, wanted, depth, true);
    const LightTable light = reference.light();
    result.light_error = std::max(colour_error(engine.sun_colour(), light.sun_irradiance(0)),
                                  colour_error(engine.sky_colour(), light.sky_irradiance({0, 0, 1})));
    return result;
}

std::string Comparison::text() const {
    char text[300];
    std::snprintf(text, sizeof text,
                  "sky in %.1f %% of the pixels; its radiance within %.3f %% of the CPU's, the land's within %.3f %%, light "
                  "within %.2g %%; land where rays "
                  "meet it in %.2f %%, its depth "
                  "within %.2f %% in nine of ten",
                  100 * sky_share, 100 * sky_error, 100 * land_error, 100 * light_error, 100 * land_agrees, 100 * depth_error);
    return text;
}

std::string Comparison::complaint() const {
    const auto beyond = [](const char* what, double is, double bound) {
        return std::string(what) + ": " + std::to_string(is) + ", bound " + std::to_string(bound);
    };
    if (!(sky_error <= sky_bound)) return beyond("radiance of the sky", sky_error, sky_bound);
    if (!(land_error <= land_radiance_bound)) return beyond("radiance of the land", land_error, land_radiance_bound);
    if (!(light_error <= light_bound)) return beyond("light", light_error, light_bound);
    if (!(land_agrees >= land_bound)) return beyond("land", land_agrees, land_bound);
    if (!(depth_error <= depth_bound)) return beyond("depth", depth_error, depth_bound);
    return "";
}

}  // namespace aureole::ogre
