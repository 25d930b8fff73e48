#include "composite/composite.h"

#include "common/check.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>

namespace aureole::detail {

namespace {

/// Where tables of light are sums, what shadows take from the ground is found at each triplet beforehand.
std::size_t ground_runs_of(const ModelKernels& kernels, const ShadowPass& shadows) {
    return shadows.enabled() && kernels.triplets.empty() ? kernels.shadow_triplets.size() : 0;
}

/// As far as the device knows its textures.
void check_sizes(const rhi::Device& device, const CompositeSettings& settings, const CompositeTargets& targets) {
    const auto print = [](const rhi::Extent& e) { return std::to_string(e.width) + "x" + std::to_string(e.height); };
    const auto extent_of = [&](rhi::Texture texture) {
        const rhi::TextureDesc* desc = texture ? device.find(texture) : nullptr;
        return desc ? desc->extent : targets.extent;
    };
    const rhi::Extent size = extent_of(targets.target);
    if (!(size == targets.extent))
        reject("targets.extent", print(targets.extent), print(size) + ", the size of targets.target");
    const auto same = [&](rhi::Texture texture, const char* field) {
        const rhi::Extent given = extent_of(texture);
        if (!(given == size)) reject(field, print(given), print(size) + ", the size of targets.target");
    };
    if (settings.scene_color) same(targets.scene_color, "targets.scene_color");
    if (settings.scene_depth) same(targets.scene_depth, "targets.scene_depth");
    same(targets.directions, "targets.directions");
}

/// As far as the device knows it. Kernels are made for one format, which no device compares with the texture's.
void check_format(const rhi::Device& device, const CompositeSettings& settings, const CompositeTargets& targets) {
    const rhi::TextureDesc* desc = device.find(targets.target);
    if (desc != nullptr && desc->format != settings.target_format)
        reject("targets.target", rhi::to_string(desc->format),
               std::string(rhi::to_string(settings.target_format)) + ", CompositeSettings::target_format");
}

void check_apart(bool read, rhi::Texture texture, rhi::Texture target, const char* field) {
    if (read && texture == target)
        reject(field, "the same image as targets.target", "another one: what is read is not written");
}

}  // namespace

void validate(const CompositeSettings& settings) {
    check("composite.exposure", settings.exposure, 1e-30, 1e30);
    check("composite.sun_lobe_g", settings.sun_lobe_g, 0, 0.9999);
    check_enum("composite.target_format", settings.target_format, rhi::Format::d32_float, "a colour format");
    if (settings.target_format == rhi::Format::undefined || settings.target_format == rhi::Format::d32_float)
        reject("composite.target_format", rhi::to_string(settings.target_format), "a colour format");
    check_enum("composite.tone_map", settings.tone_map, ToneMap::aces_fitted, "none or aces_fitted");
}

void check_targets(const rhi::Device& device, const CompositeSettings& settings, bool shadows,
                   const CompositeTargets& targets) {
    const auto need = [](bool wanted, rhi::Texture texture, const char* field) {
        if (wanted && !texture) reject(field, "null", "a texture, as CompositeSettings asks for it");
    };
    need(true, targets.target, "targets.target");
    need(settings.scene_color, targets.scene_color, "targets.scene_color");
    need(settings.scene_depth, targets.scene_depth, "targets.scene_depth");
    if (targets.directions && shadows)
        throw Error(ErrorCode::unsupported, "targets.directions", "a texture",
                    "null with ViewSettings::shadows, which are found along the rays of the camera alone");
    detail::check("targets.extent.width", targets.extent.width, 1, device.capabilities().max_texture_2d);
    detail::check("targets.extent.height", targets.extent.height, 1, device.capabilities().max_texture_2d);
    check_apart(settings.scene_color, targets.scene_color, targets.target, "targets.scene_color");
    check_apart(settings.scene_depth, targets.scene_depth, targets.target, "targets.scene_depth");
    check_apart(true, targets.directions, targets.target, "targets.directions");
    check_format(device, settings, targets);
    check_sizes(device, settings, targets);
}

CompositePass::CompositePass(ViewResources& shared, const ModelKernels& kernels, const ShadowPass& shadows,
                             const CompositeSettings& settings)
    : shared_(shared),
      kernels_(kernels),
      shadows_(shadows),
      settings_(settings),
      ground_runs_(ground_runs_of(kernels, shadows)),
      runs_(runs_of(shared, kernels)) {
    runs_.insert(runs_.begin(), kernels.shadow_triplets.begin(),
                 kernels.shadow_triplets.begin() + static_cast<std::ptrdiff_t>(ground_runs_));
    prepared_.reserve(max_prepared + 1);
    make_pipelines(false);
}

const rhi::Shader& CompositePass::shader(std::size_t run) const noexcept {
    if (run < ground_runs_) return shaders::ground_loss;
    const ModelKernels& kernels = *runs_[run].kernels;
    return draws(run) ? *kernels.composite_raster : *kernels.composite;
}

void CompositePass::make_pipelines(bool given_directions) {
    std::vector<rhi::Pipeline>(&pair)[2] = pipelines_[given_directions ? 1 : 0];
    for (const bool from_space : {false, true}) {
        std::vector<rhi::Pipeline>& kept = pair[from_space ? 1 : 0];
        std::vector<rhi::Pipeline> pipelines;  // all of them, or none
        if (!kept.empty() || (from_space && kernels_.space_constant == 0)) continue;
        for (std::size_t run = 0; run < runs_.size(); ++run) {
            Specialize values = specialization(runs_[run], given_directions, from_space);
            values.set(53, run == ground_runs_ && run > 0);
            pipelines.push_back(draws(run) ? shared_.objects.raster(shader(run), values.values(), settings_.target_format)
                                           : shared_.objects.compute(shader(run), values.values()));
        }
        kept = std::move(pipelines);
    }
}

Specialize CompositePass::specialization(const TripletKernels& run, bool given_directions, bool from_space) const {
    Specialize values = run.shared->specialize();
    for (const rhi::Specialization& value : run.kernels->specialization) values.set(value);
    values.set(16, settings_.scene_color).set(17, settings_.scene_depth);
    values.set(18, kernels_.aerial_perspective && settings_.scene_depth);
    values.set(19, settings_.sun_disk).set(20, static_cast<int>(settings_.tone_map)).set(21, settings_.encode_srgb);
    values.set(22, settings_.dither).set(23, given_directions);
    values.storing(settings_.target_format);
    values.set(37, settings_.sun_lobe_g > 0).set(38, shadows_.enabled());
    if (kernels_.space_constant != 0) values.set(kernels_.space_constant, from_space);
    if (shadows_.enabled()) {
        values.set(39, static_cast<int>(shadows_.settings().size.depth));
        values.set(40, static_cast<int>(shadows_.settings().cascades));
    }
    return values;
}

CompositePass::Prepared CompositePass::bind(const CompositeTargets& targets, rhi::Texture shadow_map, std::uint64_t use) const {
    Prepared prepared{targets, shared_.objects.sibling(), {}, {}, use};
    while (prepared.sums.size() < sums_between(runs_.size()))
        prepared.sums.push_back(prepared.objects->texture({"composite sum", rhi::Dimension::d2, rhi::Format::rgba32_float,
                                                           targets.extent, rhi::Usage::sampled | rhi::Usage::storage}));
    for (std::size_t run = 0; run < runs_.size(); ++run) prepared.bindings.push_back(bind(prepared, run, shadow_map));
    return prepared;
}

rhi::BindingSet CompositePass::bind(const Prepared& prepared, std::size_t run, rhi::Texture shadow_map) const {
    const CompositeTargets& targets = prepared.targets;
    const ViewResources& shared = *runs_[run].shared;
    const AirResources& air = shared.air;
    const auto sum = [&](std::size_t after) { return prepared.sums[after % prepared.sums.size()].handle; };
    // Slots that the settings leave unread still need a readable texture.
    const auto or_blank = [&](rhi::Texture texture) { return texture ? texture : air.profile_table.handle; };
    std::vector<rhi::Binding> slots = tables(run);
    slots.insert(slots.end(), {{0, {}, {}, air.block.handle},
                               {1, {}, {}, shared.block.handle},
                               {5, or_blank(targets.scene_color), air.nearest, {}},
                               {6, or_blank(targets.scene_depth), air.nearest, {}},
                               {7, air.phase_table.handle, air.nearest, {}},
                               {8, or_blank(targets.directions), air.nearest, {}},
                               {9, run + 1 < runs_.size() ? sum(run) : targets.target, {}, {}},
                               {10, air.profile_table.handle, air.nearest, {}},
                               {12, or_blank(shadows_.table().handle), shadows_.enabled() ? air.linear : air.nearest, {}},
                               {13, or_blank(shadow_map), air.nearest, {}},
                               {14, {}, {}, shadows_.enabled() ? shadows_.block() : shared.block.handle},
                               shared.triplet_binding(),
                               {16, run > 0 ? sum(run - 1) : air.profile_table.handle, air.nearest, {}}});
    const rhi::Pipeline pipeline = pipelines_[targets.directions ? 1 : 0][0][run];
    return prepared.objects->bindings("composite", pipeline, bindings_of(shader(run), slots));
}

std::vector<rhi::Binding> CompositePass::tables(std::size_t run) const {
    const TripletKernels& of = runs_[run];
    return run < ground_runs_ ? std::vector<rhi::Binding>{{2, of.transmittance, of.shared->air.linear, {}}}
                              : of.kernels->tables;
}

void CompositePass::prepare(const CompositeTargets& targets) {
    check_targets(shared_.objects.device(), settings_, shadows_.enabled(), targets);
    if (find(targets) != nullptr) return;
    make_pipelines(static_cast<bool>(targets.directions));
    prepared_.push_back(bind(targets, shadows_.map(), ++uses_));
    if (prepared_.size() <= max_prepared) return;
    const auto oldest = std::min_element(prepared_.begin(), prepared_.end(),
                                         [](const Prepared& a, const Prepared& b) { return a.last_used < b.last_used; });
    prepared_.erase(oldest);
}

void CompositePass::prepare_as(const CompositePass& other) {
    std::vector<const Prepared*> order;
    for (const Prepared& p : other.prepared_) order.push_back(&p);
    std::sort(order.begin(), order.end(), [](const Prepared* a, const Prepared* b) { return a->last_used < b->last_used; });
    for (const Prepared* p : order) prepare(p->targets);
}

std::vector<CompositePass::Prepared> CompositePass::prepared_with(rhi::Texture shadow_map) const {
    std::vector<Prepared> fresh;
    fresh.reserve(prepared_.capacity());
    for (const Prepared& p : prepared_) fresh.push_back(bind(p.targets, shadow_map, p.last_used));
    return fresh;
}

void CompositePass::release(const CompositeTargets& targets) noexcept {
    std::erase_if(prepared_, [&](const Prepared& p) { return p.targets == targets; });
}

CompositePass::Prepared* CompositePass::find(const CompositeTargets& targets) noexcept {
    for (Prepared& p : prepared_)
        if (p.targets == targets) return &p;
    return nullptr;
}

void CompositePass::invalidate() noexcept {
    for (Prepared& p : prepared_)
        for (TrackedTexture& sum : p.sums) forget(sum);
}

void CompositePass::record(rhi::CommandList& commands, const CompositeTargets& targets, bool from_space, std::uint64_t frame,
                           PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    Prepared* p = find(targets);
    if (p == nullptr) return;
    p->last_used = ++uses_;
    const glm::vec4 size(static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height),
                         static_cast<float>(frame % 1024), 0.0F);
    const auto push = std::as_bytes(std::span(&size, 1));
    const bool space = from_space && kernels_.space_constant != 0;
    const std::span<const rhi::Pipeline> pipelines = pipelines_[targets.directions ? 1 : 0][space ? 1 : 0];
    PassScope scope(commands, report, timestamps, index);
    const rhi::Extent pixels{targets.extent.width, targets.extent.height, 1};
    report.bytes_written = std::uint64_t{pixels.width} * pixels.height * rhi::bytes_per_texel(settings_.target_format);
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        TrackedTexture* sum = run + 1 < runs_.size() ? &p->sums[run % p->sums.size()] : nullptr;
        if (sum != nullptr) move(commands, {{sum, rhi::State::storage_write}});
        if (draws(run)) {
            commands.draw_fullscreen({pipelines[run], p->bindings[run], push, targets.target});
            report.invocations += std::uint64_t{pixels.width} * pixels.height;
        } else {
            scope.dispatch(shader(run), pipelines[run], p->bindings[run], pixels, push);
        }
        if (sum == nullptr) continue;
        move(commands, {{sum, rhi::State::sampled}});
        report.bytes_written += sum->bytes;
    }
}

}  // namespace aureole::detail
