#include "measure/aerial.h"

#include "app/solution.h"
#include "app/trace_eyes.h"
#include "io/csv.h"
#include "measure/sampling.h"
#include "terrain/pixel_rays.h"

#include <aureole/models/reference.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_distance_km = 1e-3;  // what lies at the camera has no depth
constexpr double most_of_the_way = 0.9;
constexpr double vertical_fov_deg = 60, overhead_radiance = 0.06, least_cosine = 0.01;

void check_view(const AerialView& view, const std::string& place) {
    check_row({view.sun_zenith_deg, view.altitude_km, 90, view.azimuth_deg}, place);
}

std::string name_of_view(std::size_t i) { return "view " + std::to_string(i + 1); }

void check_views(std::span<const AerialView> views) {
    for (std::size_t i = 0; i < views.size(); ++i) check_view(views[i], name_of_view(i));
}

Camera camera_of(const Planet& planet, const AerialView& view) {
    return look(planet.bottom_radius_m, std::max(view.altitude_km, 0.0) * 1000, view.azimuth_deg * degree, 0,
                vertical_fov_deg * degree, static_cast<double>(aerial_width) / aerial_height);
}

/// Calls `visit(pixel, direction in the camera's axes)`.
template <class Visit>
void each_pixel(const PixelRays& rays, const Visit& visit) {
    for (std::uint32_t y = 0; y < rays.height; ++y)
        for (std::uint32_t x = 0; x < rays.width; ++x) visit(std::size_t{y} * rays.width + x, rays.in_view(x, y));
}

/// Along a ray with the zenith's cosine `mu`, km; infinite if it misses the ground. With r^2 - R^2 = h (2 R + h) as the product
/// of both ways out of the sphere nothing cancels.
double distance_to_ground(const Planet& planet, double altitude_km, double mu) {
    const double bottom = planet.bottom_radius_m / 1000, h = std::max(altitude_km, 0.0);
    const double product = h * (2 * bottom + h), middle = -(bottom + h) * mu;
    if (mu >= 0 || middle * middle < product) return std::numeric_limits<double>::infinity();
    return product / (middle + std::sqrt(middle * middle - product));
}

/// What a host would hand to the composite, and what comes back.
class AerialTarget {
public:
    /// `chosen`: not every pixel is wanted every time.
    AerialTarget(Backend& backend, bool chosen) : textures_(backend) {
        const rhi::Extent extent{aerial_width, aerial_height, 1};
        constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;
        targets_.extent = extent;
        targets_.target =
            textures_.create("radiance", rhi::Format::rgba32_float, extent, rhi::Usage::storage | rhi::Usage::copy_source);
        textures_.make_ready(targets_.target, rhi::State::storage_write);
        targets_.scene_color = textures_.create("scene colour", rhi::Format::rgba32_float, extent, given);
        targets_.scene_depth = textures_.create("scene depth", rhi::Format::d32_float, extent, given);
        if (chosen) targets_.directions = textures_.create("directions", rhi::Format::rgba32_float, extent, given);
    }

    void show(const Planet& planet, const AerialView& view) {
        const Camera camera = camera_of(planet, view);
        const PixelRays rays(camera, aerial_width, aerial_height);
        const std::vector<double> distances = aerial_distances(planet, view);
        std::vector<float> depth(aerial_pixels),
            color(4 * aerial_pixels, static_cast<float>(geometry_radiance(view.sun_zenith_deg)));
        directions_.assign(aerial_pixels, glm::dvec3(0));
        each_pixel(rays, [&](std::size_t pixel, const glm::dvec3& in_view) {
            depth[pixel] = static_cast<float>(depth_value(camera.projection, -in_view.z * distances[pixel] * 1000));
            directions_[pixel] = rays.to_world * in_view;
        });
        const rhi::State color_before = shown_ ? rhi::State::sampled : rhi::State::undefined;
        const rhi::State depth_before = shown_ ? rhi::State::depth_read : rhi::State::undefined;
        textures_.upload(targets_.scene_color, std::as_bytes(std::span(color)), color_before, rhi::State::sampled);
        textures_.upload(targets_.scene_depth, std::as_bytes(std::span(depth)), depth_before, rhi::State::depth_read);
        shown_ = true;
    }

    /// Of what is shown these pixels alone; the others are black, and nothing is done for them.
    void choose(std::span<const std::size_t> pixels) {
        std::vector<float> texels(4 * aerial_pixels);
        for (const std::size_t pixel : pixels)
            for (int c = 0; c < 3; ++c)
                texels[4 * pixel + static_cast<std::size_t>(c)] = static_cast<float>(directions_[pixel][c]);
        textures_.upload(targets_.directions, std::as_bytes(std::span(texels)),
                         chosen_ ? rhi::State::sampled : rhi::State::undefined, rhi::State::sampled);
        chosen_ = true;
    }

    [[nodiscard]] const CompositeTargets& targets() const { return targets_; }
    [[nodiscard]] std::vector<Rgb> read() {
        const std::vector<double> texels =
            textures_.read_doubles(targets_.target, 4 * aerial_pixels, rhi::State::storage_write);
        std::vector<Rgb> radiance;
        for (std::size_t i = 0; i < aerial_pixels; ++i)
            radiance.emplace_back(texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]);
        return radiance;
    }

private:
    DeviceTextures textures_;
    CompositeTargets targets_;
    std::vector<glm::dvec3> directions_;
    bool shown_ = false, chosen_ = false;
};

ViewSettings view_settings() {
    ViewSettings settings;
    settings.aerial_perspective_distance_m = aerial_farthest_km * 1000;
    settings.light = false;
    return settings;
}
CompositeSettings composite_settings() {
    CompositeSettings settings;
    settings.target_format = rhi::Format::rgba32_float;
    settings.scene_color = settings.scene_depth = true;
    settings.sun_disk = false;
    return settings;
}

/// Looks at geometry through air whose tables have been recorded.
class AerialEye {
public:
    AerialEye(Backend& backend, Atmosphere& air, const AerialTarget& target)
        : backend_(backend), air_(air), view_(air_, view_settings(), composite_settings()) {
        view_.prepare_composite(target.targets());
    }

    /// One composite of what the target shows.
    [[nodiscard]] std::vector<Rgb> see(AerialTarget& target, const AerialView& view, std::uint64_t frame = 0) {
        Sun sun;
        sun.direction = probe_direction(view.sun_zenith_deg, 0);
        view_.update(camera_of(air_.parameters().planet, view), {&sun, 1});
        air_.set_frame(frame);
        backend_.run([&](rhi::CommandList& commands) {
            view_.record(commands);
            view_.record_composite(commands, target.targets());
        });
        return target.read();
    }

private:
    Backend& backend_;
    Atmosphere& air_;
    View view_;
};

void check_finite(const Rgb& value, const std::string& place, std::size_t pixel) {
    if (std::isfinite(value.r + value.g + value.b)) return;
    throw Error(ErrorCode::internal, place + ": the radiance of pixel (" + std::to_string(pixel % aerial_width) + ", " +
                                         std::to_string(pixel / aerial_width) + ") is not finite");
}

/// An eye for every air of the colours, for one seed.
class TracedAerial {
public:
    TracedAerial(Backend& backend, const AtmosphereParameters& parameters, const AerialView& view,
                 const TraceSettings& settings)
        : backend_(backend), view_(view), settings_(settings), colours_(parameters, settings.spectral), target_(backend, true) {
        target_.show(parameters.planet, view);
    }

    /// DrawRound
    bool draw(std::uint64_t round, std::span<const std::size_t> wanted, std::span<Rgb> values,
              const std::function<bool()>& stop) {
        prepare(round / seed_rounds);
        target_.choose(wanted);
        for (const std::size_t pixel : wanted) values[pixel] = Rgb(0);
        for (std::size_t air = 0; air < eyes_.size(); ++air) {
            if (stop && stop()) return false;
            const std::vector<Rgb> seen = eyes_[air]->eye.see(target_, view_, round % seed_rounds);
            for (const std::size_t pixel : wanted) values[pixel] += colours_.part(air, seen[pixel]);
        }
        for (const std::size_t pixel : wanted) check_finite(values[pixel], "the view", pixel);
        return true;
    }

private:
    struct Traced {
        Traced(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model, const AerialTarget& target)
            : air(solved(backend, parameters, model)), eye(backend, *air, target) {}
        std::unique_ptr<Atmosphere> air;
        AerialEye eye;
    };

    void prepare(std::uint64_t seeds) {
        if (seeds == seeds_) return;
        models::ReferenceSettings settings;
        settings.paths_per_frame = trace_batch_paths;
        eyes_.clear();
        for (std::size_t air = 0; air < colours_.airs().size(); ++air) {
            settings.seed = nth_seed(settings_, seeds, air);
            eyes_.push_back(std::make_unique<Traced>(backend_, colours_.airs()[air], models::reference(settings), target_));
        }
        seeds_ = seeds;
    }

    Backend& backend_;
    AerialView view_;
    TraceSettings settings_;
    TraceColours colours_;
    AerialTarget target_;
    std::vector<std::unique_ptr<Traced>> eyes_;
    std::optional<std::uint64_t> seeds_;  // the how many-th
};

}  // namespace

double geometry_radiance(double sun_zenith_deg) {
    return overhead_radiance * std::max(std::cos(sun_zenith_deg * degree), least_cosine);
}

TraceParameters aerial_parameters() {
    return {{"pixels", std::to_string(aerial_width) + "x" + std::to_string(aerial_height)},
            {"vertical_fov_deg", print_number(vertical_fov_deg)},
            {"nearest_km", print_number(aerial_nearest_km)},
            {"farthest_km", print_number(aerial_farthest_km)},
            {"most_of_the_way_to_the_ground", print_number(most_of_the_way)},
            {"geometry_under_overhead_sun_per_sr", print_number(overhead_radiance)},
            {"least_cosine_of_its_sun", print_number(least_cosine)}};
}

std::vector<AerialPixel> aerial_geometry(const Planet& planet, const AerialView& view) {
    const PixelRays rays(camera_of(planet, view), aerial_width, aerial_height);
    std::vector<AerialPixel> pixels(aerial_pixels);
    each_pixel(rays, [&](std::size_t pixel, const glm::dvec3& in_view) {
        const double turns = (static_cast<double>(pixel) + 0.5) / std::numbers::phi;
        const double drawn = aerial_nearest_km * std::pow(aerial_farthest_km / aerial_nearest_km, turns - std::floor(turns));
        const double mu = (rays.to_world * in_view).z;  // the camera stands on the +z axis
        const double ground = distance_to_ground(planet, view.altitude_km, mu);
        pixels[pixel] = {std::max(std::min(drawn, most_of_the_way * ground), least_distance_km), mu};
    });
    return pixels;
}

std::vector<double> aerial_distances(const Planet& planet, const AerialView& view) {
    std::vector<double> distances;
    for (const AerialPixel& pixel : aerial_geometry(planet, view)) distances.push_back(pixel.distance_km);
    return distances;
}

std::vector<std::vector<Rgb>> aerial(Backend& backend, const AtmosphereParameters& parameters, const ModelPtr& model,
                                     std::span<const AerialView> views) {
    check_views(views);
    if (views.empty()) return {};
    return aerial(backend, *solved(backend, parameters, model), views);
}

std::vector<std::vector<Rgb>> aerial(Backend& backend, Atmosphere& air, std::span<const AerialView> views) {
    check_views(views);
    if (views.empty()) return {};
    AerialTarget target(backend, false);
    AerialEye eye(backend, air, target);
    std::vector<std::vector<Rgb>> pictures;
    for (std::size_t i = 0; i < views.size(); ++i) {
        target.show(air.parameters().planet, views[i]);
        const std::vector<Rgb>& picture = pictures.emplace_back(eye.see(target, views[i]));
        for (std::size_t pixel = 0; pixel < picture.size(); ++pixel) check_finite(picture[pixel], name_of_view(i), pixel);
    }
    backend.check();
    return pictures;
}

std::optional<AerialTruth> trace_aerial(Backend& backend, const AtmosphereParameters& parameters, const AerialView& view,
                                        const TraceSettings& settings, const std::function<void(double)>& progress,
                                        const std::function<bool()>& stop) {
    settings.validate();
    if (settings.orders != 0)
        throw Error(ErrorCode::invalid_argument, "orders", std::to_string(settings.orders), "0 for aerial perspective");
    check_view(view, "the view");
    TracedAerial traced(backend, parameters, view, settings);
    const auto draw = [&](std::uint64_t round, std::span<const std::size_t> wanted, std::span<Rgb> values) {
        return traced.draw(round, wanted, values, stop);
    };
    const auto sampled = sample(aerial_pixels, settings.error, settings.max_paths / trace_batch_paths, draw, progress);
    if (!sampled) return std::nullopt;
    backend.check();
    AerialTruth truth{sampled->values, {}, sampled->reached};
    for (const std::uint64_t rounds : sampled->rounds) truth.paths.push_back(rounds * trace_batch_paths);
    return truth;
}

}  // namespace aureole::app
