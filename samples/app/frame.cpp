#include "app/frame.h"

#include "app/meter.h"
#include "app/solution.h"
#include "common/scene_settings.h"

#include <spdlog/spdlog.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <variant>

namespace aureole::app {
namespace {

constexpr std::uint32_t meter_side = 192;
constexpr std::uint32_t longest_aspect = 1000;  // a camera's (camera.h)

/// Of the picture's shape, with `meter_side` pixels on its longer side.
rhi::Extent meter_extent(std::uint32_t width, std::uint32_t height) {
    const std::uint32_t longer = std::max(width, height);
    const auto scaled = [&](std::uint32_t side) { return std::max(meter_side * side / longer, 1u); };
    return {scaled(width), scaled(height), 1};
}

/// Said before anything is made, in the words of the command line.
void check_size(const FrameOptions& options, std::uint32_t most, bool film) {
    const std::string given = std::to_string(options.width) + "x" + std::to_string(options.height);
    if (std::max(options.width, options.height) / std::min(options.width, options.height) >= longest_aspect)
        throw Error(ErrorCode::invalid_argument, "--size", given, "one side less than 1000 times as long as the other");
    const std::uint32_t width = options.width * options.samples, height = options.height * options.samples;
    const std::uint32_t rows = film ? most / 3 : most;  // ReferenceSettings::film_height
    if (width <= most && height <= rows) return;
    if (width <= most && height <= most)
        throw Error(ErrorCode::unsupported, "--size " + given + " with --samples " + std::to_string(options.samples),
                    "a film of " + std::to_string(height) + " rows",
                    "at most " + std::to_string(rows) + " on this device; fewer samples or a smaller size");
    throw Error(ErrorCode::unsupported, "--size " + given + " with --samples " + std::to_string(options.samples),
                "a composite of " + std::to_string(width) + "x" + std::to_string(height),
                "at most " + std::to_string(most) + " pixels a side on this device; fewer samples or a smaller size");
}

}  // namespace

/// The textures that a view composites from and into.
struct FrameRenderer::Canvas {
    Canvas(Backend& backend, const CompositeSettings& composite, rhi::Extent extent)
        : textures(backend), state(composite.raster ? rhi::State::color_attachment : rhi::State::storage_write) {
        const rhi::Usage written = composite.raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
        targets.extent = extent;
        targets.target = textures.create("picture", composite.target_format, extent, written | rhi::Usage::copy_source);
        textures.make_ready(targets.target, state);
        if (composite.scene_depth) {
            constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;
            targets.scene_color = textures.create("land colour", rhi::Format::rgba32_float, extent, given);
            targets.scene_depth = textures.create("land depth", rhi::Format::d32_float, extent, given);
        }
    }

    void give_land(std::span<const float> rgba, std::span<const float> depth) {
        const rhi::State color_before = filled ? rhi::State::sampled : rhi::State::undefined;
        const rhi::State depth_before = filled ? rhi::State::depth_read : rhi::State::undefined;
        textures.upload(targets.scene_color, std::as_bytes(rgba), color_before, rhi::State::sampled);
        textures.upload(targets.scene_depth, std::as_bytes(depth), depth_before, rhi::State::depth_read);
        filled = true;
    }

    [[nodiscard]] std::size_t pixels() const { return std::size_t{targets.extent.width} * targets.extent.height; }

    DeviceTextures textures;
    rhi::State state;
    CompositeTargets targets;
    bool filled = false;
};

/// A view with what it composites from and into.
struct FrameRenderer::Target : Canvas {
    Target(Backend& backend_in, Atmosphere& air, const ViewSettings& settings, const CompositeSettings& composite_in,
           rhi::Extent extent)
        : Canvas(backend_in, composite_in, extent),
          backend(backend_in),
          composite(composite_in),
          shadowed(settings.shadows.cascades > 0),
          view(air, settings, composite) {
        view.prepare_composite(targets);
    }

    void give_shadows(const TerrainShadows& shadows) {
        constexpr std::uint32_t side = TerrainShadows::side;
        const rhi::State before = shadow_map.texture ? rhi::State::sampled : rhi::State::undefined;
        if (!shadow_map.texture)
            shadow_map.texture =
                textures.create("shadow map", rhi::Format::r32_float, {side * TerrainShadows::cascades, side, 1},
                                rhi::Usage::sampled | rhi::Usage::copy_destination);
        textures.upload(shadow_map.texture, std::as_bytes(std::span(shadows.depth)), before, rhi::State::sampled);
        std::copy(shadows.world_to_map.begin(), shadows.world_to_map.end(), shadow_map.world_to_map.begin());
        view.set_shadow_map(shadow_map);
    }

    /// Every pass of the view once, for a small picture that nobody sees, by a camera that is none of the scene's.
    void warm_up(Camera camera, const std::vector<Sun>& suns) {
        // Drivers compile once more for powers of two (Mesa's software rasterizer does).
        const auto small_side = [](std::uint32_t side) { return std::has_single_bit(side) ? 16u : 24u; };
        Canvas small(backend, composite, {small_side(targets.extent.width), small_side(targets.extent.height), 1});
        const std::vector<float> nothing(4 * small.pixels());
        if (composite.scene_depth) small.give_land(nothing, std::span(nothing).first(small.pixels()));
        camera.position_m *= 1 + 1e-6;
        view.prepare_composite(small.targets);
        view.update(camera, suns);
        backend.run([&](rhi::CommandList& commands) {
            view.record(commands);
            view.record_composite(commands, small.targets);
        });
        view.release_composite(small.targets);
    }

    /// The view's tables alone.
    void record(std::vector<PassTime>& times) {
        const TimestampSlots slots = if_supported(backend, view_slots);
        backend.run([&](rhi::CommandList& commands) { view.record(commands, slots); });
        collect_times(backend, view.reports().first(view.reports().size() - 1), view_slots, times);
    }

    void draw(std::vector<PassTime>* times) {
        const TimestampSlots slots = if_supported(backend, view_slots);
        backend.run([&](rhi::CommandList& commands) {
            view.record(commands, slots);
            view.record_composite(commands, targets, slots);
        });
        if (times) collect_times(backend, view.reports(), view_slots, *times);
    }

    Backend& backend;
    CompositeSettings composite;
    bool shadowed;
    View view;
    ShadowMap shadow_map;
};

/// Shows a mean of composites: geometry that fills the picture, in front of all air.
struct FrameRenderer::Display {
    Display(Backend& backend, const Scene& scene, CompositeSettings composite, rhi::Extent extent)
        : air(backend.device(), scene.atmosphere, model_by_name("fog")),
          target(backend, air, settings(scene), given(composite), extent) {
        backend.run([&](rhi::CommandList& commands) { air.record(commands); });
    }
    static ViewSettings settings(const Scene& scene) {
        ViewSettings settings;
        settings.projection = scene.camera.projection;
        settings.aerial_perspective = settings.light = false;
        return settings;
    }
    static CompositeSettings given(CompositeSettings composite) {
        composite.scene_color = composite.scene_depth = true;
        composite.sun_disk = false;
        return composite;
    }
    void draw(const Camera& camera, std::span<const float> rgba, double exposure) {
        target.give_land(rgba, std::vector<float>(target.pixels(), 0.5F));  // of any depth
        target.view.set_exposure(exposure);
        target.view.update(camera, {});
        target.draw(nullptr);
    }

    Atmosphere air;
    Target target;
};

FrameRenderer::FrameRenderer(Backend& backend, const Scene& scene, const Land* land, const FrameOptions& options)
    : backend_(backend),
      scene_(scene),
      land_(land),
      options_(options),
      rounds_(options.model ? std::nullopt
                            : rounds_of(scene.model, options.width, options.height, options.samples, land != nullptr)),
      air_(backend.device(), scene.atmosphere, options.model ? options.model : metering_model(scene.model)) {
    if (options.raster && !backend.device().capabilities().raster)
        throw Error(ErrorCode::unsupported, "--raster: " + backend.describe() + " has no raster pipelines");
    check_size(options, backend.device().capabilities().max_texture_2d, rounds_ && !rounds_->averaged());
    if (rounds_)
        traced_ = std::make_unique<Atmosphere>(backend.device(), scene.atmosphere,
                                               scene.model.in_its_colours(models::reference(rounds_->settings)));
    make_targets();
}

void FrameRenderer::make_targets() {
    ViewSettings settings = view_settings(scene_, land_ != nullptr, land_ ? TerrainShadows::cascades : 0);
    settings.light = false;
    settings.aerial_perspective = settings.aerial_perspective && options_.aerial_perspective;

    CompositeSettings shown = composite_settings(scene_, land_ != nullptr);
    shown.raster = options_.raster;
    CompositeSettings linear = shown;
    linear.target_format = rhi::Format::rgba32_float;
    shown.target_format = rhi::Format::rgba8_unorm;
    shown.tone_map = scene_.tone_map;
    shown.encode_srgb = shown.dither = true;
    const rhi::Extent extent{options_.width * options_.samples, options_.height * options_.samples, 1};
    const auto make = [&] {
        return std::make_unique<Target>(backend_, traced_ ? *traced_ : air_, settings,
                                        options_.linear || averaged() ? linear : shown, extent);
    };
    try {
        target_ = make();
    } catch (const Error& problem) {
        if (problem.field() != "view.shadows.cascades") throw;
        spdlog::warn("[terrain] air_shadows_m: the model {} takes no shadows in the air; the picture has none",
                     scene_.model.name);
        settings.shadows = {};
        target_ = make();
    }
    if (averaged() && !options_.linear) display_ = std::make_unique<Display>(backend_, scene_, shown, extent);

    if (!options_.linear && !scene_.exposure.factor) {
        CompositeSettings metered = composite_settings(scene_, land_ != nullptr);
        metered.sun_disk = false;
        metered.sun_lobe_g = 0;
        metered.target_format = rhi::Format::rgba32_float;
        meter_ = std::make_unique<Target>(backend_, air_, settings, metered, meter_extent(options_.width, options_.height));
    }
}

FrameRenderer::~FrameRenderer() = default;

/// Drivers compile a pipeline when it is first used: what is timed must not be the first use. Air with tables of the scene's
/// own would get new pipelines by a change, so there the air's passes are left as they are. Paths take longer than compiling.
void FrameRenderer::warm_up(const Camera& camera, const std::vector<Sun>& suns) {
    if (warm_ || !options_.warm_up || traced_ || backend_.cpu() || !if_supported(backend_, air_slots).enabled) return;
    warm_ = true;
    AtmosphereParameters other = scene_.atmosphere;
    other.planet.ground_albedo = Rgb(1) - 0.5 * other.planet.ground_albedo;
    const bool tabulated = std::ranges::any_of(other.terms, [](const DensityTerm& term) {
        return std::holds_alternative<TabulatedProfile>(term.profile) || std::holds_alternative<TabulatedPhase>(term.phase);
    });
    const bool twice = !tabulated && air_.progress() == 1;  // not where it takes seconds
    if (twice) air_.set_parameters(other);
    solve(backend_, air_, air_times_);
    if (twice) air_times_.clear();
    target_->warm_up(camera, suns);
    if (twice) air_.set_parameters(scene_.atmosphere);
}

const View& FrameRenderer::view() const noexcept { return target_->view; }

void FrameRenderer::follow_air() {
    air_.set_parameters(scene_.atmosphere);
    if (traced_) traced_->set_parameters(scene_.atmosphere);
}

void FrameRenderer::record_air(std::vector<PassTime>& times) {
    times = std::exchange(air_times_, {});
    solve(backend_, air_, times);
}

/// Where suns and air are those of the picture before, so is the light.
const TerrainLight& FrameRenderer::light_of_land(const std::vector<Sun>& suns) {
    if (light_ && lit_by_ == suns && lit_in_ == scene_.atmosphere) return *light_;
    light_ = land_->measure_light(backend_, air_, suns);
    lit_by_ = suns;
    lit_in_ = scene_.atmosphere;
    return *light_;
}

double FrameRenderer::measure_exposure(const std::vector<Sun>& suns, const TerrainLight* light) {
    Target& meter = *meter_;
    const Camera camera = camera_of(scene_, camera_altitude_m(), meter.targets.extent.width, meter.targets.extent.height);
    if (light) {
        const TerrainPicture land = land_->cast(camera, *light, meter.targets.extent.width, meter.targets.extent.height);
        meter.give_land(land.rgba, land.depth);
    }
    meter.view.update(camera, suns);
    meter.draw(nullptr);
    return automatic_exposure(meter.textures.read_floats(meter.targets.target, 4 * meter.pixels(), meter.state),
                              solid_angles(camera, meter.targets.extent.width, meter.targets.extent.height));
}

/// The picture as it is updated. Rounds of a model that traces paths are frames of their own.
void FrameRenderer::draw(Frame& frame, std::uint64_t number, const std::function<void()>& after_round) {
    Target& target = *target_;
    const std::size_t values = 4 * target.pixels();
    std::vector<float> mean(averaged() ? values : 0);
    const std::size_t first = frame.times.size();
    for (std::uint32_t round = 0; round < rounds(); ++round) {
        if (traced_) {
            traced_->set_frame(number * rounds() + round);
            backend_.run([&](rhi::CommandList& commands) { traced_->record(commands); });
        }
        std::vector<PassTime> times;
        if (averaged() || round + 1 == rounds())
            target.draw(&times);
        else
            target.record(times);
        add_times(times, frame.times, first);
        if (averaged()) {
            const std::vector<float> traced = target.textures.read_floats(target.targets.target, values, target.state);
            for (std::size_t i = 0; i < values; ++i) mean[i] += (traced[i] - mean[i]) / static_cast<float>(round + 1);
        }
        if (after_round) after_round();
    }

    Target* last = &target;
    const std::uint32_t width = target.targets.extent.width, height = target.targets.extent.height;
    if (display_) {
        last = &display_->target;
        display_->draw(camera_of(scene_, camera_altitude_m(), width, height), mean, frame.exposure);
    }
    backend_.check();
    if (options_.linear) {
        if (!averaged()) mean = target.textures.read_floats(target.targets.target, values, target.state);
        frame.linear = downsample(std::span<const float>(mean), width, height, options_.samples);
    } else {
        frame.display =
            downsample(std::span<const std::uint8_t>(last->textures.read_bytes(last->targets.target, values, last->state)),
                       width, height, options_.samples);
    }
}

Frame FrameRenderer::render(const std::vector<Sun>& suns, std::uint64_t number, const std::function<void()>& after_round) {
    Frame frame;
    Target& target = *target_;
    follow_air();
    const std::uint32_t width = target.targets.extent.width, height = target.targets.extent.height;
    const Camera camera = camera_of(scene_, camera_altitude_m(), width, height);
    warm_up(camera, suns);
    air_.set_frame(number);
    record_air(frame.times);
    const TerrainLight* light = land_ ? &light_of_land(suns) : nullptr;
    if (!options_.linear) {
        frame.exposure = scene_.exposure.factor ? *scene_.exposure.factor : measure_exposure(suns, light);
        frame.exposure *= std::exp2(scene_.exposure.stops);
    }

    if (light) {
        const TerrainPicture land = land_->cast(camera, *light, width, height);
        target.give_land(land.rgba, land.depth);
        if (target.shadowed)
            target.give_shadows(
                land_->cast_shadows(camera, glm::normalize(suns.front().direction), scene_.terrain->air_shadows_m));
    }
    target.view.set_exposure(averaged() ? 1 : frame.exposure);
    target.view.update(camera, suns);
    draw(frame, number, after_round);
    frame.passes.assign(air().reports().begin(), air().reports().end());
    frame.passes.insert(frame.passes.end(), target.view.reports().begin(), target.view.reports().end());
    return frame;
}

double exposure_of(const Scene& scene, std::uint32_t width, std::uint32_t height) {
    if (scene.exposure.factor) return *scene.exposure.factor * std::exp2(scene.exposure.stops);
    const std::unique_ptr<Backend> backend = open_backend({.name = "cpu"});
    std::optional<Land> land;
    if (scene.terrain) land.emplace(scene, scene.terrain->height_map);
    const rhi::Extent small = meter_extent(width, height);
    FrameOptions options{.width = small.width, .height = small.height};
    options.warm_up = false;
    return FrameRenderer(*backend, scene, land ? &*land : nullptr, options).render(suns_of(scene)).exposure;
}

}  // namespace aureole::app
