#include "app/pass_costs.h"

#include "app/cost_scene.h"
#include "app/pass_counts.h"
#include "app/pass_times.h"
#include "app/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <span>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
/// Costs of features are measured with so many times fewer pixels each way.
constexpr std::uint32_t coarser = 2;

PassCostOptions at_fewer_pixels(PassCostOptions options) {
    options.width = std::max(options.width / coarser, 1U);
    options.height = std::max(options.height / coarser, 1U);
    return options;
}

/// What composites are drawn into.
struct Scenes {
    Scenes(Backend& backend, const PassCostOptions& options)
        : whole(backend, options), coarse(backend, at_fewer_pixels(options)) {}
    CostTextures whole, coarse;
};

/// Another composite than that of sky alone.
struct Variant {
    const char* name;
    bool geometry = false, shadows = false, coarse = false;
    std::uint32_t suns = 1;
    bool air = true;  // before geometry
};
constexpr Variant with_geometry{"composite_geometry", true};
constexpr Variant with_two_suns{"composite_two_suns", false, false, true, 2},
    with_shadows{"composite_shadows", true, true, true}, without_air{"composite_bare", true, false, true, 1, false};

std::vector<Variant> variants_of(const PassCostOptions& options, const Model& model) {
    std::vector<Variant> variants;
    if (options.geometry) variants.push_back(with_geometry);
    if (!options.features) return variants;
    variants.push_back(with_two_suns);
    variants.push_back(without_air);
    if (model.has_shadows()) variants.push_back(with_shadows);
    return variants;
}

ViewSettings view_settings(const Variant& variant) {
    ViewSettings settings;
    settings.max_suns = variant.suns;
    settings.aerial_perspective = variant.air;
    settings.shadows.cascades = variant.shadows ? 1 : 0;
    return settings;
}

/// A view that draws one of them.
class VariantView {
public:
    VariantView(Atmosphere& air, const PassCostOptions& options, const Scenes& scenes, const Variant& variant)
        : variant_(variant),
          targets_((variant.coarse ? scenes.coarse : scenes.whole).targets(variant.geometry)),
          pixels_(variant.coarse ? double(options.width) * options.height / targets_.extent.width / targets_.extent.height : 1),
          view_(air, view_settings(variant), cost_composite(options, variant.geometry)) {
        view_.prepare_composite(targets_);
        if (variant.shadows) view_.set_shadow_map(scenes.coarse.shadow_map(air.parameters().planet));
    }

    void update(const Camera& camera, const Sun& sun) {
        std::array<Sun, 2> suns{sun, sun};
        suns[1].direction.y = suns[1].direction.x;
        suns[1].direction.x = 0;
        view_.update(camera, std::span(suns).first(variant_.suns));
    }
    /// Tables, then the composite; of both what counts.
    void draw(Backend& backend, std::vector<PassTime>& times) {
        const TimestampSlots slots = if_supported(backend, view_slots);
        backend.run([&](rhi::CommandList& commands) { view_.record(commands, slots); });
        std::vector<PassTime> tables;
        collect_times(backend, view_.reports(), slots, tables);
        std::ranges::copy_if(tables, std::back_inserter(times), [](const PassTime& time) { return time.name == "shadows"; });
        backend.run([&](rhi::CommandList& commands) { view_.record_composite(commands, targets_, slots); });
        std::vector<PassTime> composite;
        collect_times(backend, view_.reports().last(1), {true, slots.first + 2 * static_cast<std::uint32_t>(before())},
                      composite);
        times.push_back({variant_.name, pixels_ * composite.at(0).milliseconds});
    }
    /// The backend counts.
    [[nodiscard]] rhi::CpuCounts count(Backend& backend) {
        backend.run([&](rhi::CommandList& commands) { view_.record(commands); });
        return count_passes(backend, [&](rhi::CommandList& commands) { view_.record_composite(commands, targets_); })
            .at("composite");
    }

    [[nodiscard]] const Variant& variant() const { return variant_; }
    [[nodiscard]] std::uint64_t invocations() const { return view_.reports().back().invocations; }
    [[nodiscard]] std::uint64_t table_bytes() const { return view_.table_bytes(); }

private:
    [[nodiscard]] std::size_t before() const { return view_.reports().size() - 1; }

    Variant variant_;
    CompositeTargets targets_;
    double pixels_;  // for each of these
    View view_;
};

/// One model under test.
class Subject {
public:
    Subject(Backend& backend, const PassCostOptions& options, const Scenes& scenes, const CostSubject& of)
        : backend_(backend),
          targets_(scenes.whole.targets(false)),
          camera_(cost_camera(of.air.planet, options)),
          albedo_(of.air.planet.ground_albedo),
          air_(backend.device(), of.air, of.model),
          plain_(air_, {}, cost_composite(options, false)) {
        for (const PassReport& report : air_.reports()) names_.emplace_back(report.name);
        for (const PassReport& report : plain_.reports()) names_.emplace_back(report.name);
        result.air_passes = air_.reports().size();
        result.view_passes = plain_.reports().size() - 1;
        plain_.prepare_composite(targets_);
        for (const Variant& variant : variants_of(options, *of.model)) {
            variants_.push_back(std::make_unique<VariantView>(air_, options, scenes, variant));
            if (variant.shadows) names_.emplace_back("shadows");
            names_.emplace_back(variant.name);
        }
    }

    /// One round, with or without features; what it took.
    std::vector<PassTime> run(std::uint32_t round, bool features) {
        update(round);
        std::vector<PassTime> times;
        draw_plain();
        collect_times(backend_, air_.reports(), air_slots, times);
        collect_times(backend_, plain_.reports(), view_slots, times);
        for (const auto& variant : variants_)
            if (features || !variant->variant().coarse) variant->draw(backend_, times);
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
    CostCounts count(bool composites) {
        update(0);
        auto counts = count_passes(backend_, [&](rhi::CommandList& commands) { record_plain(commands, {}, {}, composites); });
        if (!composites) return counts;
        for (const auto& variant : variants_)
            if (!variant->variant().coarse) counts[variant->variant().name] = variant->count(backend_);
        return counts;
    }

    void set_counts(const CostCounts& counts) { counts_ = counts; }

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
        for (const auto& variant : variants_)
            if (variant->variant().shadows) result.shadow_bytes = variant->table_bytes() - plain_.table_bytes();
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
        for (const auto& variant : variants_) variant->update(camera_, sun);
    }
    void record_plain(rhi::CommandList& commands, TimestampSlots air, TimestampSlots view, bool composite) {
        air_.record(commands, air);
        plain_.record(commands, view);
        if (composite) plain_.record_composite(commands, targets_, view);
    }
    void draw_plain() {
        const TimestampSlots air = if_supported(backend_, air_slots), view = if_supported(backend_, view_slots);
        backend_.run([&](rhi::CommandList& commands) { record_plain(commands, air, view, true); });
    }

    [[nodiscard]] std::uint64_t invocations_of(std::string_view name) const {
        for (const auto& variant : variants_)
            if (name == variant->variant().name) return variant->invocations();
        for (const std::span<const PassReport> reports : {air_.reports(), plain_.reports()})
            for (const PassReport& report : reports)
                if (report.name == name) return report.invocations;
        return 0;
    }

    Backend& backend_;
    CompositeTargets targets_;
    Camera camera_;
    Rgb albedo_;
    Atmosphere air_;
    View plain_;
    std::vector<std::unique_ptr<VariantView>> variants_;
    std::vector<std::string> names_;  // of all passes, as PassCosts has them
    std::map<std::string, std::vector<double>> samples_;
    std::vector<double> per_frame_, frame_, rebuild_;
    CostCounts counts_;
};

std::unique_ptr<Subject> open(Backend& backend, const PassCostOptions& options, const Scenes& scenes,
                              const CostSubject& subject) {
    try {
        return std::make_unique<Subject>(backend, options, scenes, subject);
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
    const Scenes scenes(backend, options);
    std::vector<std::unique_ptr<Subject>> running;
    for (const CostSubject& subject : subjects) running.push_back(open(backend, options, scenes, subject));
    std::vector<std::uint32_t> missing(running.size(), options.frames);
    for (std::size_t i = 0; i < options.known.size(); ++i) {
        for (const CostRound& round : options.known[i]) running.at(i)->keep(round);
        missing.at(i) -= static_cast<std::uint32_t>(std::min<std::size_t>(options.known[i].size(), options.frames));
    }
    const std::uint32_t most = running.empty() ? 0 : std::ranges::max(missing);
    const std::uint32_t rounds = most > 0 ? most + options.warm_up : 0;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        // Each after another one in each round: what the one before leaves in caches hits all alike.
        const bool features = (round + options.warm_up) % 2 == 0;  // of those that count the first, the third ...
        for (std::size_t i = 0; i < running.size(); ++i) {
            const std::size_t turn = (i + round) % running.size(), next = round % 2 == 0 ? turn : running.size() - 1 - turn;
            if (missing[next] == 0) continue;
            const CostRound times = running[next]->run(round, features);
            if (round < options.warm_up) continue;
            running[next]->keep(times);
            --missing[next];
            if (options.after_measured) options.after_measured(next, times);
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
        counted.features = false;
        if (options.counted_width > 0) counted.width = options.counted_width, counted.height = options.counted_height;
        const Scenes inputs(*counter, counted);
        for (std::size_t i = 0; i < running.size(); ++i) {
            if (i < options.known_counts.size()) {
                running[i]->set_counts(options.known_counts[i]);
                continue;
            }
            const CostCounts counts = open(*counter, counted, inputs, subjects[i])->count(options.composites);
            running[i]->set_counts(counts);
            if (options.after_counted) options.after_counted(counts);
        }
    }
    std::vector<PassCosts> results;
    for (const auto& subject : running) {
        subject->finish();
        results.push_back(std::move(subject->result));
    }
    return results;
}

}  // namespace aureole::app
