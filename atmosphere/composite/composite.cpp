#include "composite/composite.h"

#include "common/check.h"

#include <algorithm>

namespace aureole::detail {

namespace {

bool same_targets(const CompositeTargets& a, const CompositeTargets& b) noexcept {
    return a.scene_color == b.scene_color && a.scene_depth == b.scene_depth && a.target == b.target &&
           a.directions == b.directions && a.extent == b.extent;
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

CompositePass::CompositePass(ViewResources& shared, const ModelKernels& kernels, const ShadowPass& shadows,
                             const CompositeSettings& settings)
    : shared_(shared),
      kernels_(kernels),
      shadows_(shadows),
      settings_(settings),
      shader_(settings.raster ? kernels.composite_raster : kernels.composite) {
    prepared_.reserve(max_prepared + 1);
    make_pipelines(false);
}

void CompositePass::make_pipelines(bool given_directions) {
    rhi::Pipeline(&pair)[2] = pipelines_[given_directions ? 1 : 0];
    if (!pair[0]) pair[0] = pipeline(given_directions, false);
    if (kernels_.space_constant != 0 && !pair[1]) pair[1] = pipeline(given_directions, true);
}

rhi::Pipeline CompositePass::pipeline(bool given_directions, bool from_space) {
    Specialize values = shared_.specialize();
    for (const rhi::Specialization& value : kernels_.specialization) values.set(value);
    values.set(16, settings_.scene_color).set(17, settings_.scene_depth);
    values.set(18, kernels_.aerial_perspective && settings_.scene_depth);
    values.set(19, settings_.sun_disk).set(20, static_cast<int>(settings_.tone_map)).set(21, settings_.encode_srgb);
    values.set(22, settings_.dither).set(23, given_directions);
    values.set(37, settings_.sun_lobe_g > 0).set(38, shadows_.enabled());
    if (kernels_.space_constant != 0) values.set(kernels_.space_constant, from_space);
    if (shadows_.enabled()) {
        values.set(39, static_cast<int>(shadows_.settings().size.depth));
        values.set(40, static_cast<int>(shadows_.settings().cascades));
    }
    return settings_.raster ? shared_.objects.raster(*shader_, values.values(), settings_.target_format)
                            : shared_.objects.compute(*shader_, values.values());
}

void CompositePass::check(const CompositeTargets& targets) const {
    const auto need = [](bool wanted, rhi::Texture texture, const char* field) {
        if (wanted && !texture) reject(field, "null", "a texture, as CompositeSettings asks for it");
    };
    need(true, targets.target, "targets.target");
    need(settings_.scene_color, targets.scene_color, "targets.scene_color");
    need(settings_.scene_depth, targets.scene_depth, "targets.scene_depth");
    if (targets.directions && shadows_.enabled())
        throw Error(ErrorCode::unsupported, "targets.directions", "a texture",
                    "null with ViewSettings::shadows, which are found along the rays of the camera alone");
    detail::check("targets.extent.width", targets.extent.width, 1, shared_.objects.device().capabilities().max_texture_2d);
    detail::check("targets.extent.height", targets.extent.height, 1, shared_.objects.device().capabilities().max_texture_2d);
    check_sizes(targets);
}

/// As far as the device knows its textures.
void CompositePass::check_sizes(const CompositeTargets& targets) const {
    const auto print = [](const rhi::Extent& e) { return std::to_string(e.width) + "x" + std::to_string(e.height); };
    const auto extent_of = [&](rhi::Texture texture) {
        const rhi::TextureDesc* desc = texture ? shared_.objects.device().find(texture) : nullptr;
        return desc ? desc->extent : targets.extent;
    };
    const rhi::Extent size = extent_of(targets.target);
    if (!(size == targets.extent))
        reject("targets.extent", print(targets.extent), print(size) + ", the size of targets.target");
    const auto same = [&](rhi::Texture texture, const char* field) {
        const rhi::Extent given = extent_of(texture);
        if (!(given == size)) reject(field, print(given), print(size) + ", the size of targets.target");
    };
    if (settings_.scene_color) same(targets.scene_color, "targets.scene_color");
    if (settings_.scene_depth) same(targets.scene_depth, "targets.scene_depth");
    same(targets.directions, "targets.directions");
}

CompositePass::Prepared CompositePass::bind(const CompositeTargets& targets, rhi::Texture shadow_map, std::uint64_t use) const {
    AirResources& air = shared_.air;
    // Slots that the settings leave unread still need a readable texture.
    const auto or_blank = [&](rhi::Texture texture) { return texture ? texture : air.profile_table.handle; };
    std::vector<rhi::Binding> slots = kernels_.tables;
    slots.insert(slots.end(), {{0, {}, {}, air.block.handle},
                               {1, {}, {}, shared_.block.handle},
                               {5, or_blank(targets.scene_color), air.nearest, {}},
                               {6, or_blank(targets.scene_depth), air.nearest, {}},
                               {7, air.phase_table.handle, air.nearest, {}},
                               {8, or_blank(targets.directions), air.nearest, {}},
                               {9, targets.target, {}, {}},
                               {10, air.profile_table.handle, air.nearest, {}},
                               {12, or_blank(shadows_.table().handle), shadows_.enabled() ? air.linear : air.nearest, {}},
                               {13, or_blank(shadow_map), air.nearest, {}},
                               {14, {}, {}, shadows_.enabled() ? shadows_.block() : shared_.block.handle}});
    auto objects = shared_.objects.sibling();
    const rhi::BindingSet set =
        objects->bindings("composite", pipelines_[targets.directions ? 1 : 0][0], bindings_of(*shader_, slots));
    return {targets, std::move(objects), set, use};
}

void CompositePass::prepare(const CompositeTargets& targets) {
    check(targets);
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
    std::erase_if(prepared_, [&](const Prepared& p) { return same_targets(p.targets, targets); });
}

CompositePass::Prepared* CompositePass::find(const CompositeTargets& targets) noexcept {
    for (Prepared& p : prepared_)
        if (same_targets(p.targets, targets)) return &p;
    return nullptr;
}

void CompositePass::record(rhi::CommandList& commands, const CompositeTargets& targets, bool from_space, std::uint64_t frame,
                           PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    Prepared* p = find(targets);
    if (p == nullptr) return;
    p->last_used = ++uses_;
    const glm::vec4 size(static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height),
                         static_cast<float>(frame % 1024), 0.0F);
    const auto push = std::as_bytes(std::span(&size, 1));
    const rhi::Pipeline pipeline = pipelines_[targets.directions ? 1 : 0][from_space && kernels_.space_constant != 0 ? 1 : 0];
    PassScope scope(commands, report, timestamps, index);
    const rhi::Extent pixels{targets.extent.width, targets.extent.height, 1};
    if (settings_.raster) {
        commands.draw_fullscreen({pipeline, p->bindings, push, targets.target});
        report.invocations = std::uint64_t{pixels.width} * pixels.height;
    } else {
        scope.dispatch(*shader_, pipeline, p->bindings, pixels, push);
    }
    report.bytes_written = report.invocations * rhi::bytes_per_texel(settings_.target_format);
}

}  // namespace aureole::detail
