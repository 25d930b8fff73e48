#include "physics/sky.h"

#include <aureole/models/aureole.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace aureole::physics {
namespace {

constexpr rhi::Extent sky_extent{64, 16, 1};
constexpr std::size_t sky_texels = std::size_t{sky_extent.width} * sky_extent.height;
constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;
constexpr rhi::Usage target_usage = rhi::Usage::storage | rhi::Usage::copy_source;

ViewSettings sky_settings(const SkyOptions& options) {
    ViewSettings settings;
    settings.max_suns = options.suns;
    settings.aerial_perspective = false;
    settings.light = options.light;
    return settings;
}
CompositeSettings sky_composite(const SkyOptions& options) {
    CompositeSettings settings;
    settings.target_format = rhi::Format::rgba32_float;
    settings.sun_disk = options.sun_disk;
    settings.sun_lobe_g = options.sun_lobe_g;
    settings.scene_color = options.beyond > 0;
    return settings;
}

ViewSettings picture_settings(double last_slice_m, std::uint32_t suns) {
    ViewSettings settings;
    settings.max_suns = suns;
    settings.aerial_perspective_distance_m = last_slice_m;
    settings.light = false;
    return settings;
}
CompositeSettings picture_composite() {
    CompositeSettings settings;
    settings.target_format = rhi::Format::rgba32_float;
    settings.scene_color = settings.scene_depth = true;
    settings.sun_disk = false;
    return settings;
}

}  // namespace

glm::dvec3 direction(double zenith_rad, double azimuth_rad) {
    return {std::sin(zenith_rad) * std::cos(azimuth_rad), std::sin(zenith_rad) * std::sin(azimuth_rad), std::cos(zenith_rad)};
}

Sun sun_at(double zenith_rad, double angular_radius_rad) {
    Sun sun;
    sun.direction = direction(zenith_rad);
    sun.angular_radius_rad = angular_radius_rad;
    sun.limb_darkening = LimbDarkening::none;
    return sun;
}

QualitySettings fine() {
    QualitySettings quality = QualitySettings::high();
    quality.name = "fine";
    quality.transmittance_nodes = 16;
    quality.multi_scatter_orders = 8;
    quality.multi_scatter_zenith = 6;
    quality.multi_scatter_azimuth = 4;
    quality.sky_view_nodes = 16;
    return quality;
}

QualitySettings fine_single() {
    QualitySettings quality = fine();
    quality.multi_scatter = {4, 4, 1};
    quality.multi_scatter_zenith = quality.multi_scatter_azimuth = quality.multi_scatter_nodes = 2;
    quality.multi_scatter_orders = 2;
    return quality;
}

DensityTerm even_term(const Rgb& scattering_per_m, const Rgb& absorption_per_m, const PhaseFunction& phase) {
    return {"even", ExponentialProfile{1e12}, scattering_per_m, absorption_per_m, phase};
}

Sky::Sky(Machine& machine, const AtmosphereParameters& parameters, const SkyOptions& options)
    : machine_(machine),
      suns_(options.suns),
      air_(machine.device(), parameters, options.model ? options.model : models::aureole(options.quality)),
      view_(air_, sky_settings(options), sky_composite(options)) {
    targets_.extent = sky_extent;
    targets_.target = machine.texture("radiance", rhi::Format::rgba32_float, sky_extent, target_usage);
    machine.move(targets_.target, rhi::State::undefined, rhi::State::storage_write);
    targets_.directions = machine.texture("directions", rhi::Format::rgba32_float, sky_extent, given);
    if (options.beyond > 0) {
        targets_.scene_color = machine.texture("beyond", rhi::Format::rgba32_float, sky_extent, given);
        const std::vector<float> texels(4 * sky_texels, static_cast<float>(options.beyond));
        machine.upload(targets_.scene_color, texels, rhi::State::undefined, rhi::State::sampled);
    }
    view_.prepare_composite(targets_);
}

Sky::~Sky() {
    for (const rhi::Texture texture : {targets_.target, targets_.directions, targets_.scene_color}) machine_.destroy(texture);
}

void Sky::stand(double altitude_m, const Sun& sun) {
    place({0, 0, air_.parameters().planet.bottom_radius_m + altitude_m}, {&sun, 1});
}

void Sky::place(const glm::dvec3& position_m, std::span<const Sun> suns) {
    Camera camera = look(air_.parameters().planet.bottom_radius_m, 0, 0, 0, 1, 1);  // its rays are not used
    camera.position_m = position_m;
    view_.update(camera, suns);
}

void Sky::look_at(std::span<const glm::dvec3> directions) {
    std::vector<float> texels(4 * sky_texels, 0.0F);  // no direction, no work
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (int c = 0; c < 3; ++c) texels[4 * i + static_cast<std::size_t>(c)] = static_cast<float>(directions[i][c]);
    machine_.upload(targets_.directions, texels, directions_state_, rhi::State::sampled);
    directions_state_ = rhi::State::sampled;
}

void Sky::update_tables() {
    machine_.run([&](rhi::CommandList& commands) {
        air_.record(commands);
        view_.record(commands);
    });
}

std::vector<Rgb> Sky::radiance(std::span<const glm::dvec3> directions) {
    std::vector<Rgb> result;
    update_tables();
    while (result.size() < directions.size()) {
        const std::span<const glm::dvec3> rest = directions.subspan(result.size());
        const std::span<const glm::dvec3> batch = rest.first(std::min(rest.size(), sky_texels));
        look_at(batch);
        machine_.run([&](rhi::CommandList& commands) { view_.record_composite(commands, targets_); });
        const std::vector<glm::dvec4> texels = machine_.read(targets_.target, sky_texels, rhi::State::storage_write);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const Rgb value(texels[i]);
            if (!std::isfinite(sum(value))) throw std::runtime_error("a radiance is not finite");
            result.push_back(value);
        }
    }
    return result;
}

Rgb Sky::radiance(const glm::dvec3& direction) { return radiance(std::span(&direction, 1)).front(); }

std::vector<glm::dvec4> Sky::light() {
    update_tables();
    return machine_.read(view_.light_table(), std::size_t{10} * suns_, rhi::State::sampled);
}

Picture::Picture(Machine& machine, const AtmosphereParameters& parameters, const ModelPtr& model, double last_slice_m,
                 std::uint32_t suns)
    : machine_(machine),
      air_(machine.device(), parameters, model),
      view_(air_, picture_settings(last_slice_m, suns), picture_composite()) {
    targets_.extent = {width, height, 1};
    targets_.target = machine.texture("picture", rhi::Format::rgba32_float, targets_.extent, target_usage);
    machine.move(targets_.target, rhi::State::undefined, rhi::State::storage_write);
    targets_.scene_color = machine.texture("scene colour", rhi::Format::rgba32_float, targets_.extent, given);
    targets_.scene_depth = machine.texture("scene depth", rhi::Format::d32_float, targets_.extent, given);
    view_.prepare_composite(targets_);
}

Picture::~Picture() {
    for (const rhi::Texture texture : {targets_.target, targets_.scene_color, targets_.scene_depth}) machine_.destroy(texture);
}

void Picture::place(const Camera& camera, std::span<const Sun> suns) {
    camera_ = camera;
    view_.update(camera, suns);
}

glm::dvec3 Picture::direction(std::uint32_t x, std::uint32_t y) const {
    const glm::dmat3 world_to_view(camera_.view);
    const double right = (2 * (x + 0.5) / width - 1) / camera_.projection[0][0];
    const double up = (1 - 2 * (y + 0.5) / height) / camera_.projection[1][1];
    return glm::normalize(glm::dvec3(right, up, -1) * world_to_view);  // row vector: times the transpose
}

std::vector<Rgb> Picture::render(double distance_m, const Rgb& color) {
    constexpr std::size_t pixels = std::size_t{width} * height;
    return render(std::vector<double>(pixels, distance_m), std::vector<Rgb>(pixels, color));
}

std::vector<Rgb> Picture::render(std::span<const double> distances_m, std::span<const Rgb> colors_in) {
    const glm::dvec3 forward = glm::dvec3(0, 0, -1) * glm::dmat3(camera_.view);
    std::vector<float> colors, depths;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::size_t i = std::size_t{y} * width + x;
            for (int c = 0; c < 3; ++c) colors.push_back(static_cast<float>(colors_in[i][c]));
            colors.push_back(1);
            // Reversed infinite depth (aureole::look): near / (distance along the axis).
            depths.push_back(
                static_cast<float>(camera_.projection[3][2] / (distances_m[i] * glm::dot(direction(x, y), forward))));
        }
    machine_.upload(targets_.scene_color, colors, filled_ ? rhi::State::sampled : rhi::State::undefined, rhi::State::sampled);
    machine_.upload(targets_.scene_depth, depths, filled_ ? rhi::State::depth_read : rhi::State::undefined,
                    rhi::State::depth_read);
    filled_ = true;
    machine_.run([&](rhi::CommandList& commands) {
        air_.record(commands);
        view_.record(commands);
        view_.record_composite(commands, targets_);
    });
    std::vector<Rgb> result;
    for (const glm::dvec4& texel : machine_.read(targets_.target, std::size_t{width} * height, rhi::State::storage_write)) {
        result.emplace_back(texel);
        if (!std::isfinite(sum(result.back()))) throw std::runtime_error("a pixel is not finite");
    }
    return result;
}

double sum(const Rgb& color) { return color.r + color.g + color.b; }

double apart(const Rgb& a, const Rgb& b) {
    const Rgb difference = glm::abs(a - b);
    return sum(difference) > 0 ? sum(difference) / sum(glm::abs(b)) : 0;
}

}  // namespace aureole::physics
