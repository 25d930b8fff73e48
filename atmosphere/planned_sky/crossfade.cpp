#include "planned_sky/crossfade.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>

namespace aureole::detail {

CrossfadePass::CrossfadePass(rhi::Device& device, const std::uint64_t& frame, rhi::Format target_format, bool raster)
    : objects_(device, frame), format_(target_format), raster_(raster), nearest_(objects_.sampler(rhi::Filter::nearest)) {
    pipeline_ =
        raster ? objects_.raster(shaders::crossfade_raster, {}, target_format) : objects_.compute(shaders::crossfade, {});
}

rhi::State CrossfadePass::written() const noexcept {
    return raster_ ? rhi::State::color_attachment : rhi::State::storage_write;
}

CrossfadePass::Target* CrossfadePass::find(rhi::Texture target) noexcept {
    const auto found = std::ranges::find(targets_, target, &Target::texture);
    return found == targets_.end() ? nullptr : &*found;
}

bool CrossfadePass::prepare(rhi::Texture target, rhi::Extent extent) {
    if (const Target* known = find(target)) {
        const rhi::Extent size = known->pictures.before.extent;
        if (size.width == extent.width && size.height == extent.height) return false;
    }
    Target made{target, objects_.sibling(), {}, {}};
    const rhi::Usage usage = rhi::Usage::sampled | (raster_ ? rhi::Usage::color_attachment : rhi::Usage::storage);
    const auto picture = [&](const char* name) {
        return made.objects->texture({name, rhi::Dimension::d2, format_, {extent.width, extent.height, 1}, usage});
    };
    made.pictures = {picture("sky before"), picture("sky after")};
    std::vector<rhi::Binding> slots{{0, made.pictures.before.handle, nearest_, {}},
                                    {1, made.pictures.after.handle, nearest_, {}}};
    if (!raster_) slots.push_back({2, target, {}, {}});
    made.bindings = made.objects->bindings("crossfade", pipeline_, slots);
    targets_.reserve(targets_.size() + 1);
    release(target);  // of another size
    targets_.push_back(std::move(made));
    return true;
}

void CrossfadePass::release(rhi::Texture target) noexcept {
    std::erase_if(targets_, [&](const Target& one) { return one.texture == target; });
}

CrossfadePass::Pictures* CrossfadePass::pictures(rhi::Texture target) noexcept {
    Target* found = find(target);
    return found == nullptr ? nullptr : &found->pictures;
}

void CrossfadePass::invalidate() noexcept {
    for (Target& target : targets_)
        for (TrackedTexture* picture : {&target.pictures.before, &target.pictures.after}) forget(*picture);
}

void CrossfadePass::record(rhi::CommandList& commands, rhi::Texture texture, double share) {
    Target& target = *find(texture);
    const rhi::Extent extent = target.pictures.before.extent;
    move(commands, {{&target.pictures.before, rhi::State::sampled}, {&target.pictures.after, rhi::State::sampled}});
    const glm::vec4 push(static_cast<float>(extent.width), static_cast<float>(extent.height), static_cast<float>(share), 0);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    PassReport report;
    report.name = "crossfade";
    PassScope scope(commands, report, {}, 0);
    if (raster_)
        commands.draw_fullscreen({pipeline_, target.bindings, bytes, texture});
    else
        scope.dispatch(shaders::crossfade, pipeline_, target.bindings, extent, bytes);
}

}  // namespace aureole::detail
