#include "host_vulkan/script.h"

#include <aureole/atmosphere.h>
#include <aureole/cpu/cpu_device.h>
#include <aureole/light.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace host_vulkan {

using namespace aureole;

namespace {

/// Mean radiance of the half of the world that the camera looks at, by a view on the CPU: what a host does that has no frame in
/// flight yet.
Rgb radiance_ahead(const app::Scene& scene, double altitude_m) {
    const auto machine = cpu::create_cpu_device();
    rhi::Device& device = machine->device();
    Atmosphere air(device, scene.atmosphere);
    const std::vector<Sun> suns = app::suns_of(scene);
    ViewSettings settings;
    settings.max_suns = static_cast<std::uint32_t>(std::max<std::size_t>(suns.size(), 1));
    settings.aerial_perspective = false;
    View view(air, settings);
    const Camera camera = look(scene.atmosphere.planet.bottom_radius_m, altitude_m, 0, 0, 1, 1);
    view.update(camera, suns);
    std::vector<float> texels(LightTable::floats_per_sun * settings.max_suns);
    const rhi::Buffer buffer =
        device.create_buffer({"light", texels.size() * sizeof(float), rhi::Usage::read_back | rhi::Usage::copy_destination});
    rhi::CommandList& commands = machine->queue().begin();
    air.record(commands);
    view.record(commands);
    const rhi::TextureBarrier readable{view.light_table(), rhi::State::sampled, rhi::State::copy_source};
    const rhi::BufferBarrier writable{buffer, rhi::State::undefined, rhi::State::copy_destination};
    commands.barrier({&readable, 1}, {&writable, 1});
    commands.copy(rhi::TextureToBuffer{view.light_table(), buffer});
    machine->queue().submit();
    machine->queue().wait();
    device.read_buffer(buffer, std::as_writable_bytes(std::span(texels)));
    device.destroy(buffer, 0);
    const LightTable light(texels);
    return light.sky_irradiance(app::direction_of(scene.camera.pose)) / std::numbers::pi;
}

}  // namespace

double exposure_of(const app::Scene& scene, double altitude_m) {
    double factor = 1;
    if (scene.exposure.factor) {
        factor = *scene.exposure.factor;
    } else {
        const Rgb ahead = radiance_ahead(scene, altitude_m);
        factor = 0.5 / std::max(0.2126 * ahead.r + 0.7152 * ahead.g + 0.0722 * ahead.b, 1e-9);
    }
    return factor * std::exp2(scene.exposure.stops);
}

std::vector<glm::dvec4> place_spheres(const app::Scene& scene, const TerrainMesh& mesh, std::uint32_t count) {
    std::vector<glm::dvec4> spheres;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double distance = 150 * std::pow(2.2, i), radius = 0.045 * distance;
        app::ScenePose pose = scene.camera.pose;
        pose.bearing_deg += 8.0 * (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) - 3;  // the near ones in the middle
        pose.elevation_deg = -7 + 0.5 * i;
        spheres.emplace_back(glm::dvec3(0, 0, scene.atmosphere.planet.bottom_radius_m + mesh.camera_altitude_m) +
                                 distance * app::direction_of(pose),
                             radius);
    }
    return spheres;
}

Script::Script(const app::Scene& scene, const Options& options, double altitude_m, double exposure)
    : scene_(scene), options_(options), altitude_m_(altitude_m), exposure_(exposure) {}

void Script::turn(const Window::Turn& turn) {
    scene_.camera.pose.bearing_deg += turn.right_deg;
    scene_.camera.pose.elevation_deg = std::clamp(scene_.camera.pose.elevation_deg + turn.up_deg, -89.0, 89.0);
}

double Script::sway(std::uint32_t frame) const {
    if (options_.frames < 2 || frame + 1 == options_.frames) return 0;  // the last one is the scene's own, to the last bit
    return options_.sway_deg * std::sin(2 * std::numbers::pi * frame / (options_.frames - 1));
}

const std::vector<Sun>& Script::suns(std::uint32_t frame) {
    app::Scene moved = scene_;
    for (app::SceneSun& sun : moved.suns)
        sun.pose.elevation_deg = std::clamp(sun.pose.elevation_deg + 0.2 * sway(frame), -90.0, 90.0);
    suns_ = app::suns_of(moved);
    for (Sun& sun : suns_) sun.irradiance *= exposure_;
    return suns_;
}

Camera Script::camera(std::uint32_t frame, VkExtent2D size) const {
    app::Scene moved = scene_;
    moved.camera.pose.bearing_deg += sway(frame);
    return app::camera_of(moved, altitude_m_, size.width, size.height);
}

VkExtent2D Script::size(std::uint32_t frame) const {
    if (options_.resize_every == 0 || frame + 1 == options_.frames) return options_.size;
    constexpr double shares[][2] = {{1, 1}, {0.75, 0.9}, {0.5, 1.1}};
    const auto& share = shares[frame / options_.resize_every % 3];
    const auto scaled = [](std::uint32_t side, double by) { return std::max(static_cast<std::uint32_t>(side * by), 16U); };
    return {scaled(options_.size.width, share[0]), scaled(options_.size.height, share[1])};
}

}  // namespace host_vulkan
