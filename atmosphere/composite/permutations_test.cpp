// Every pipeline that the composite's settings, a view's settings and a named quality can ask for is made: all combinations on
// the CPU device, which takes microseconds for one, and a set on Vulkan in which every two choices meet, drawn under the
// validation layer (lavapipe compiles a shader when it is first used).
#include "composite/composite.h"

#include "light/light.h"
#include "models/model.h"
#include "module/air.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "passes/rig.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

/// Choices that make a permutation, and how many values each has.
enum Choice : std::size_t {
    format,
    raster,
    color,
    depth,
    disk,
    tone,
    srgb,
    dither,
    directions,
    projection,
    suns,
    froxels,
    light,
    quality,
    choices
};
constexpr std::array<rhi::Format, 11> formats{rhi::Format::r8_unorm,     rhi::Format::rgba8_unorm,    rhi::Format::rgba8_srgb,
                                              rhi::Format::bgra8_unorm,  rhi::Format::r16_float,      rhi::Format::rg16_float,
                                              rhi::Format::rgba16_float, rhi::Format::r32_float,      rhi::Format::rg32_float,
                                              rhi::Format::rgba32_float, rhi::Format::r11g11b10_float};
struct NamedModel {
    const char *model, *quality;
};
/// The qualities of one model differ in sizes alone; hillaire's default and high in the kernels that show them.
constexpr std::array<NamedModel, 4> qualities{
    {{"aureole", "low"}, {"aureole", "high"}, {"hillaire", "default"}, {"hillaire", "high"}}};
constexpr std::array<std::size_t, choices> counts{formats.size(), 2, 2, 2, 2, 2, 2, 2, 2, 3, 4, 2, 2, qualities.size()};
using Permutation = std::array<std::size_t, choices>;

CompositeSettings composite_of(const Permutation& p) {
    CompositeSettings settings;
    settings.target_format = formats[p[format]];
    settings.raster = p[raster] == 1;
    settings.scene_color = p[color] == 1;
    settings.scene_depth = p[depth] == 1;
    settings.sun_disk = p[disk] == 1;
    settings.sun_lobe_g = p[tone] == 1 ? 0.9 : 0;  // as the tone map, so that there is no choice more
    settings.tone_map = p[tone] == 1 ? ToneMap::aces_fitted : ToneMap::none;
    settings.encode_srgb = p[srgb] == 1;
    settings.dither = p[dither] == 1;
    return settings;
}

ViewSettings view_of(const Permutation& p) {
    ViewSettings settings;
    settings.projection = static_cast<Projection>(p[projection]);
    settings.max_suns = static_cast<std::uint32_t>(p[suns] + 1);
    settings.aerial_perspective = p[froxels] == 1;
    settings.light = p[light] == 1;
    settings.shadows.cascades = p[light] == 1 && p[directions] == 0 ? 2 : 0;  // as the light, where directions may have them
    return settings;
}

bool takes(const rhi::Device& device, std::size_t chosen_format, bool draws) {
    const rhi::FormatSupport support = device.format_support(formats[chosen_format], rhi::Dimension::d2);
    return draws ? support.color_attachment : support.storage;
}

std::string name_of(const Permutation& p) {
    std::string text = std::string(qualities[p[quality]].model) + " " + qualities[p[quality]].quality + ", " +
                       rhi::to_string(formats[p[format]]) + ", choices";
    for (const std::size_t value : p) text += " " + std::to_string(value);
    return text;
}

/// What a View owns (module/view.cpp), with as many composites as wanted.
struct Tables {
    Tables(detail::AirTables& air, const ViewSettings& settings)
        : objects(air.objects.sibling()),
          block(objects->constants("view", sizeof(detail::ViewBlock))),
          shared{*objects, air.shared, block, settings.max_suns, settings.projection},
          model(air.model->make_view(shared, settings)),
          light(shared, model->kernels(), settings.light),
          shadows(shared, model->kernels(), settings.shadows, air.model->transmittance_table()) {}
    std::unique_ptr<detail::Objects> objects;
    detail::TrackedBuffer block;
    detail::ViewResources shared;
    std::unique_ptr<detail::ModelView> model;
    detail::LightPass light;
    detail::ShadowPass shadows;
};

/// The host's textures for every permutation: one of each kind, of one size.
struct HostTextures {
    HostTextures(Backend& backend_in) : backend(backend_in) {
        const Image flat{extent, std::vector<glm::dvec4>(std::size_t{extent.width} * extent.height, glm::dvec4(0.5))};
        Image up = flat;
        for (glm::dvec4& texel : up.texels) texel = {0.6, 0, 0.8, 0};
        scene_color = backend.make("colour", rhi::Format::rgba16_float, flat);
        scene_depth = backend.make("depth", rhi::Format::r32_float, flat);
        world_directions = backend.make("directions", rhi::Format::rgba32_float, up);
        for (std::size_t f = 0; f < formats.size(); ++f)
            for (const bool draws : {false, true})
                if (takes(backend.device(), f, draws)) target[f][draws] = backend.make_target(formats[f], extent, state(draws));
    }
    [[nodiscard]] static rhi::State state(bool draws) {
        return draws ? rhi::State::color_attachment : rhi::State::storage_write;
    }
    [[nodiscard]] CompositeTargets targets(const Permutation& p) const {
        CompositeTargets targets;
        targets.extent = extent;
        targets.target = target[p[format]][p[raster]];
        if (p[color] == 1) targets.scene_color = scene_color;
        if (p[depth] == 1) targets.scene_depth = scene_depth;
        if (p[directions] == 1) targets.directions = world_directions;
        return targets;
    }
    static constexpr rhi::Extent extent{9, 5, 1};
    Backend& backend;
    rhi::Texture scene_color, scene_depth, world_directions;
    std::array<std::array<rhi::Texture, 2>, formats.size()> target{};
};

/// Permutations in which every two choices of the device's meet, few of them: of many at random the one that adds most pairs.
class Covering {
public:
    explicit Covering(const rhi::Device& device) : device_(device) {
        for (std::size_t a = 0; a < choices; ++a)
            for (std::size_t b = a + 1; b < choices; ++b)
                for (std::size_t i = 0; i < counts[a]; ++i)
                    for (std::size_t j = 0; j < counts[b]; ++j)
                        if (possible(a, i, b, j)) open_.insert({a, i, b, j});
    }
    [[nodiscard]] bool complete() const { return open_.empty(); }
    Permutation next() {
        Permutation best{};
        std::size_t most = 0;
        while (most == 0)
            for (int trial = 0; trial < 200; ++trial) {
                const Permutation candidate = draw();
                const std::size_t added = takes(device_, candidate[format], candidate[raster] == 1) ? news(candidate) : 0;
                if (added > most) {
                    most = added;
                    best = candidate;
                }
            }
        for (std::size_t a = 0; a < choices; ++a)
            for (std::size_t b = a + 1; b < choices; ++b) open_.erase({a, best[a], b, best[b]});
        return best;
    }

private:
    using Pair = std::array<std::size_t, 4>;
    /// Around a pair that is still open, so that the last ones are found too.
    Permutation draw() {
        Permutation p;
        for (std::size_t c = 0; c < choices; ++c) p[c] = random_() % counts[c];
        const Pair& wanted = *std::next(open_.begin(), static_cast<std::ptrdiff_t>(random_() % open_.size()));
        p[wanted[0]] = wanted[1];
        p[wanted[2]] = wanted[3];
        return p;
    }
    [[nodiscard]] bool possible(std::size_t a, std::size_t i, std::size_t b, std::size_t j) const {
        if (a != format) return true;
        if (b >= projection)
            return false;  // no kernel of a view knows the target: its format meets the composite's choices alone
        return b == raster ? takes(device_, i, j == 1) : takes(device_, i, false) || takes(device_, i, true);
    }
    [[nodiscard]] std::size_t news(const Permutation& p) const {
        std::size_t count = 0;
        for (std::size_t a = 0; a < choices; ++a)
            for (std::size_t b = a + 1; b < choices; ++b) count += open_.contains({a, p[a], b, p[b]}) ? 1 : 0;
        return count;
    }
    const rhi::Device& device_;
    std::set<Pair> open_;
    std::minstd_rand random_{1};
};

/// Calls `visit` with all combinations of the choices in [first, last), the others as they are.
template <class Visit>
void for_all(Permutation& p, std::size_t first, std::size_t last, const Visit& visit) {
    if (first == last) return visit();
    for (p[first] = 0; p[first] < counts[first]; ++p[first]) for_all(p, first + 1, last, visit);
}

}  // namespace

TEST_CASE("composite: every permutation is a pipeline of the CPU device" * doctest::test_suite("long")) {
    const auto backend = open_cpu_float(1);
    const HostTextures host(*backend);
    std::size_t made = 0;
    Permutation p{};
    for (p[quality] = 0; p[quality] < qualities.size(); ++p[quality]) {
        const NamedModel& choice = qualities[p[quality]];
        const Atmosphere air(backend->device(), presets::earth(), model_by_name(choice.model, choice.quality));
        for_all(p, projection, quality, [&] {
            p[directions] = 0;
            Tables tables(*air.impl().tables, view_of(p));
            for_all(p, format, directions, [&] {
                if (!takes(backend->device(), p[format], p[raster] == 1)) return;
                detail::CompositePass pass(tables.shared, tables.model->kernels(), tables.shadows, composite_of(p));
                for (p[directions] = 0; p[directions] < (tables.shadows.enabled() ? 1 : 2); ++p[directions]) {
                    const CompositeTargets targets = host.targets(p);
                    pass.prepare(targets);
                    made += pass.prepared(targets) ? 1 : 0;
                }
            });
        });
    }
    std::size_t kinds = 0;
    for (std::size_t f = 0; f < formats.size(); ++f)
        for (const bool draws : {false, true}) kinds += takes(backend->device(), f, draws) ? 1 : 0;
    CHECK(kinds >= 6);
    CHECK(made ==
          kinds * 64 * 2 * 3 * 4 * 2 * 2 * qualities.size() * 3 / 4);  // with light there are shadows, and no directions
}

TEST_CASE("composite: on Vulkan every two choices meet in a pipeline that draws") {
    const auto backend = open_vulkan();
    if (backend == nullptr) return;
    const HostTextures host(*backend);
    std::vector<std::unique_ptr<Atmosphere>> airs;
    airs.reserve(qualities.size());
    for (const auto& [model, name] : qualities)
        airs.push_back(std::make_unique<Atmosphere>(backend->device(), presets::earth(), model_by_name(model, name)));
    backend->run([&](rhi::CommandList& commands) {
        for (const auto& air : airs) air->record(commands);
    });
    std::size_t drawn = 0;
    for (Covering covering(backend->device()); !covering.complete(); ++drawn) {
        const Permutation p = covering.next();
        INFO(name_of(p));
        Tables tables(*airs[p[quality]]->impl().tables, view_of(p));
        detail::CompositePass pass(tables.shared, tables.model->kernels(), tables.shadows, composite_of(p));
        const CompositeTargets targets = host.targets(p);
        pass.prepare(targets);
        // What stands in the tables of such a view, and what is shown then, other tests look at.
        std::vector<PassReport> reports(tables.model->passes().size());
        for (std::size_t i = 0; i < reports.size(); ++i) reports[i].name = tables.model->passes()[i];
        PassReport report;
        report.name = "composite";
        backend->run([&](rhi::CommandList& commands) {
            detail::update_block(commands, tables.block, detail::ViewBlock{});
            tables.model->record(commands, reports, {});
            if (tables.shadows.enabled()) tables.shadows.record(commands, {}, report, {}, 2);
            pass.record(commands, targets, drawn % 2 == 1, 0, report, {}, 3);
        });
        CHECK(report.recorded);
        CHECK(backend->take_messages() == "");
    }
    CHECK(drawn >= formats.size());
    MESSAGE(drawn, " permutations drawn");
}
