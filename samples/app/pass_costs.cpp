#include "app/pass_costs.h"

#include "app/pass_counts.h"
#include "app/pass_times.h"
#include "app/quantile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double camera_altitude_m = 500;
constexpr std::string_view geometry_pass = "composite_geometry";

rhi::Format target_format(const PassCostOptions& options) {
    return options.linear ? rhi::Format::rgba16_float : rhi::Format::rgba8_unorm;
}

CompositeSettings composite_settings(const PassCostOptions& options, bool geometry) {
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

/// What a host would hand over: a plain under the camera up to the middle of the picture, then a ridge, then sky.
struct Textures {
    Textures(Backend& backend, const PassCostOptions& options) : own(backend) {
        const rhi::Extent extent{options.width, options.height, 1};
        const rhi::Usage written = options.raster ? rhi::Usage::color_attachment : rhi::Usage::storage;
        state = options.raster ? rhi::State::color_attachment : rhi::State::storage_write;
        plain.extent = geometry.extent = extent;
        plain.target = geometry.target =
            own.create("picture", target_format(options), extent, written | rhi::Usage::copy_source);
        own.make_ready(plain.target, state);

        constexpr rhi::Usage given = rhi::Usage::sampled | rhi::Usage::copy_destination;
        geometry.scene_color = own.create("scene colour", rhi::Format::rgba16_float, extent, given);
        geometry.scene_depth = own.create("scene depth", rhi::Format::d32_float, extent, given);
        std::vector<float> depth(std::size_t{options.width} * options.height);
        const Camera camera = cost_camera({}, options);  // of any planet: the matrix alone
        for (std::uint32_t y = 0; y < options.height; ++y) {
            const double down = ((y + 0.5) / options.height * 2 - 1) / camera.projection[1][1];
            const double view_depth = down > 0.005 ? camera_altitude_m / down : down > -0.1 ? 20000 : INFINITY;
            for (std::uint32_t x = 0; x < options.width; ++x)
                depth[std::size_t{y} * options.width + x] = static_cast<float>(camera.projection[3][2] / view_depth);
        }
        const std::vector<std::uint16_t> color(depth.size() * 4, 0x2000);  // 2^-7 in half floats
        own.upload(geometry.scene_color, std::as_bytes(std::span(color)), rhi::State::undefined, rhi::State::sampled);
        own.upload(geometry.scene_depth, std::as_bytes(std::span(depth)), rhi::State::undefined, rhi::State::depth_read);
    }

    DeviceTextures own;
    rhi::State state = rhi::State::undefined;
    CompositeTargets plain, geometry;
};

/// One model under test.
class Subject {
public:
    Subject(Backend& backend, const PassCostOptions& options, const Textures& textures, const CostSubject& of)
        : backend_(backend),
          textures_(textures),
          camera_(cost_camera(of.air.planet, options)),
          albedo_(of.air.planet.ground_albedo),
          air_(backend.device(), of.air, of.model),
          plain_(air_, {}, composite_settings(options, false)) {
        for (const PassReport& report : air_.reports()) names_.emplace_back(report.name);
        for (const PassReport& report : plain_.reports()) names_.emplace_back(report.name);
        result.air_passes = air_.reports().size();
        result.view_passes = plain_.reports().size() - 1;
        plain_.prepare_composite(textures.plain);
        if (!options.geometry) return;
        names_.emplace_back(geometry_pass);
        geometry_.emplace(air_, ViewSettings{}, composite_settings(options, true));
        geometry_->prepare_composite(textures.geometry);
    }

    /// One round; what it took.
    std::vector<PassTime> run(std::uint32_t round) {
        update(round);
        std::vector<PassTime> times;
        draw_plain();
        collect_times(backend_, air_.reports(), air_slots, times);
        collect_times(backend_, plain_.reports(), view_slots, times);
        if (geometry_) {
            std::vector<PassTime> geometry_times;
            draw_geometry_tables();
            draw_geometry();
            collect_times(backend_, geometry_->reports().last(1), slot_of_composite(), geometry_times);
            times.push_back({std::string(geometry_pass), geometry_times.at(0).milliseconds});
        }
        return times;
    }

    /// The times of a round that counts.
    void keep(const std::vector<PassTime>& times) {
        double air = 0, view = 0, composite = 0;
        for (const PassTime& time : times) {
            samples_[time.name].push_back(time.milliseconds);
            const auto place = static_cast<std::size_t>(std::ranges::find(names_, time.name) - names_.begin());
            if (place < result.air_passes)
                air += time.milliseconds;
            else if (place < result.air_passes + result.view_passes)
                view += time.milliseconds;
            else if (time.name == "composite")
                composite = time.milliseconds;
        }
        per_frame_.push_back(view);
        frame_.push_back(view + composite);
        rebuild_.push_back(air + view);
    }

    /// What each pass of one round does. The backend counts (BackendOptions::count_work).
    std::map<std::string, rhi::CpuCounts> count(bool composites) {
        update(0);
        auto counts = count_passes(backend_, [&](rhi::CommandList& commands) { record_plain(commands, {}, {}, composites); });
        if (!geometry_ || !composites) return counts;
        draw_geometry_tables();
        const auto again = count_passes(backend_, [&](rhi::CommandList& commands) { record_geometry(commands, {}); });
        counts[std::string(geometry_pass)] = again.at("composite");
        return counts;
    }

    void set_counts(const std::map<std::string, rhi::CpuCounts>& counts) { counts_ = counts; }

    void finish() {
        for (const std::string& name : names_) {
            PassCost& pass = result.passes.emplace_back();
            pass.name = name;
            pass.milliseconds = spread_of(samples_[name]);
            pass.invocations = invocations_of(name);
            if (const auto found = counts_.find(name); found != counts_.end()) pass.counts = found->second;
        }
        result.per_frame = spread_of(per_frame_);
        result.frame = spread_of(frame_);
        result.rebuild = spread_of(rebuild_);
        result.air_bytes = air_.table_bytes();
        result.table_bytes = result.air_bytes + plain_.table_bytes();
        const rhi::Texture froxels = plain_.aerial_perspective_table();
        const rhi::TextureDesc* desc = froxels ? backend_.device().find(froxels) : nullptr;
        if (desc != nullptr)
            result.aerial_perspective_bytes = std::uint64_t{desc->extent.width} * desc->extent.height * desc->extent.depth *
                                              rhi::bytes_per_texel(desc->format);
    }

    PassCosts result;

private:
    /// Sun and ground have moved: every pass has work to do.
    void update(std::uint32_t round) {
        AtmosphereParameters parameters = air_.parameters();
        if (parameters.planet.ground_albedo == Rgb(0)) {
            air_.invalidate();  // black ground may have kernels of its own
        } else {
            // Next to nothing: how many orders are worth while depends on it.
            parameters.planet.ground_albedo = albedo_ * (1 - 1e-4 * (1 + round % 7));
            air_.set_parameters(parameters);
        }
        Sun sun;
        const double elevation = (20 + 0.5 * (round % 100)) * degree;
        sun.direction = {std::cos(elevation), 0, std::sin(elevation)};
        plain_.update(camera_, {&sun, 1});
        if (geometry_) geometry_->update(camera_, {&sun, 1});
    }
    void record_plain(rhi::CommandList& commands, TimestampSlots air, TimestampSlots view, bool composite) {
        air_.record(commands, air);
        plain_.record(commands, view);
        if (composite) plain_.record_composite(commands, textures_.plain, view);
    }
    void record_geometry(rhi::CommandList& commands, TimestampSlots view) {
        geometry_->record_composite(commands, textures_.geometry, view);
    }
    void draw_plain() {
        const TimestampSlots air = if_supported(backend_, air_slots), view = if_supported(backend_, view_slots);
        backend_.run([&](rhi::CommandList& commands) { record_plain(commands, air, view, true); });
    }
    void draw_geometry_tables() {
        backend_.run([&](rhi::CommandList& commands) { geometry_->record(commands); });
    }
    void draw_geometry() {
        const TimestampSlots view = if_supported(backend_, view_slots);
        backend_.run([&](rhi::CommandList& commands) { record_geometry(commands, view); });
    }

    [[nodiscard]] TimestampSlots slot_of_composite() const {
        const std::size_t before = geometry_->reports().size() - 1;
        return {true, view_slots.first + 2 * static_cast<std::uint32_t>(before)};
    }
    [[nodiscard]] std::uint64_t invocations_of(std::string_view name) const {
        if (name == geometry_pass) return geometry_->reports().back().invocations;
        for (const std::span<const PassReport> reports : {air_.reports(), plain_.reports()})
            for (const PassReport& report : reports)
                if (report.name == name) return report.invocations;
        return 0;
    }

    Backend& backend_;
    const Textures& textures_;
    Camera camera_;
    Rgb albedo_;
    Atmosphere air_;
    View plain_;
    std::optional<View> geometry_;
    std::vector<std::string> names_;  // of all passes, as PassCosts has them
    std::map<std::string, std::vector<double>> samples_;
    std::vector<double> per_frame_, frame_, rebuild_;
    std::map<std::string, rhi::CpuCounts> counts_;
};

std::unique_ptr<Subject> open(Backend& backend, const PassCostOptions& options, const Textures& textures,
                              const CostSubject& subject) {
    try {
        return std::make_unique<Subject>(backend, options, textures, subject);
    } catch (const Error& error) {
        throw error.field().empty() ? Error(error.code(), subject.label + ": " + error.what())
                                    : Error(error.code(), subject.label + ": " + error.field(), error.value(), error.allowed());
    }
}

}  // namespace

Spread spread_of(std::vector<double> samples) {
    std::ranges::sort(samples);
    return {quantile(samples, 0.5), quantile(samples, 0.1), quantile(samples, 0.9)};
}

const PassCost& PassCosts::pass(std::string_view name) const {
    const auto found = std::ranges::find(passes, name, &PassCost::name);
    if (found == passes.end()) throw Error(ErrorCode::internal, "costs: no pass " + std::string(name));
    return *found;
}

std::vector<PassCosts> pass_costs(Backend& backend, std::span<const CostSubject> subjects, const PassCostOptions& options,
                                  const std::function<void()>& after_round) {
    if (!if_supported(backend, air_slots).enabled)
        throw Error(ErrorCode::unsupported, backend.describe() + " has no clock that passes can be timed with");
    const Textures textures(backend, options);
    std::vector<std::unique_ptr<Subject>> running;
    for (const CostSubject& subject : subjects) running.push_back(open(backend, options, textures, subject));
    for (const CostRound& round : options.known)
        for (std::size_t i = 0; i < running.size(); ++i) running[i]->keep(round.at(i));
    const auto known = static_cast<std::uint32_t>(std::min<std::size_t>(options.known.size(), options.frames));
    const std::uint32_t rounds = known < options.frames ? options.frames - known + options.warm_up : 0;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        // Each after another one in each round: what the one before leaves in caches hits all alike.
        CostRound times(running.size());
        for (std::size_t i = 0; i < running.size(); ++i) {
            const std::size_t turn = (i + round) % running.size(), next = round % 2 == 0 ? turn : running.size() - 1 - turn;
            times[next] = running[next]->run(round);
        }
        if (round >= options.warm_up) {
            for (std::size_t i = 0; i < running.size(); ++i) running[i]->keep(times[i]);
            if (options.after_measured) options.after_measured(times);
        }
        after_round();
    }
    backend.check();
    if (options.counts) {
        BackendOptions counting;
        counting.name = "cpu";
        counting.count_work = true;
        const std::unique_ptr<Backend> counter = open_backend(counting);
        PassCostOptions counted = options;
        if (options.counted_width > 0) counted.width = options.counted_width, counted.height = options.counted_height;
        const Textures inputs(*counter, counted);
        for (std::size_t i = 0; i < running.size(); ++i)
            running[i]->set_counts(open(*counter, counted, inputs, subjects[i])->count(options.composites));
    }
    std::vector<PassCosts> results;
    for (const auto& subject : running) {
        subject->finish();
        results.push_back(std::move(subject->result));
    }
    return results;
}

}  // namespace aureole::app
