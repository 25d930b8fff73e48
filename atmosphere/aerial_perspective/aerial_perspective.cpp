#include "aerial_perspective/aerial_perspective.h"

#include "aureole_atmosphere_shaders.h"

#include <array>

namespace aureole::detail {

AerialPerspectivePass::AerialPerspectivePass(TableViewResources& shared, bool enabled) : enabled_(enabled) {
    Objects& objects = shared.objects;
    const QualitySettings& quality = shared.air.quality;
    const bool published = quality.sampling == Sampling::published_2020;
    const rhi::Extent size = quality.aerial_perspective;
    rhi::Extent extent;
    if (enabled) extent = {size.width, size.height * (1 + shared.suns * shared.layers_per_sun()), size.depth};
    const rhi::Usage written = enabled ? rhi::Usage::storage : rhi::Usage::copy_destination;
    table_ = objects.texture(
        {"aerial_perspective", rhi::Dimension::d3, quality.froxel_format, extent, rhi::Usage::sampled | written});
    if (!enabled) {
        const std::array<std::byte, 16> black{};
        stand_in_ =
            objects.upload("aerial_perspective stand-in", std::span(black.data(), rhi::bytes_per_texel(quality.froxel_format)));
        return;
    }

    // Ours: one invocation a column. Published: one a froxel.
    invocations_ = {size.width, size.height * shared.suns, published ? size.depth : 1};
    shader_ = published ? &shaders::aerial_perspective_2020 : &shaders::aerial_perspective;
    pipeline_ = objects.compute(*shader_, shared.specialize().set(8, quality.aerial_perspective_nodes).values());
    bindings_ = objects.bindings("aerial_perspective", pipeline_,
                                 {{0, {}, {}, shared.air.block.handle},
                                  {2, shared.air.profile_table.handle, shared.air.nearest, {}},
                                  {3, shared.transmittance.handle, shared.air.linear, {}},
                                  {4, shared.multi_scatter.handle, shared.air.linear, {}},
                                  {5, {}, {}, shared.block.handle},
                                  {6, table_.handle, {}, {}},
                                  {7, shared.air.phase_table.handle, shared.air.nearest, {}}});
}

void AerialPerspectivePass::prepare(rhi::CommandList& commands) {
    if (enabled_ || table_.state != rhi::State::undefined) return;
    const rhi::BufferBarrier readable{stand_in_.handle, stand_in_.state, rhi::State::copy_source};
    commands.barrier({}, std::span(&readable, 1));
    stand_in_.state = rhi::State::copy_source;
    move(commands, {{&table_, rhi::State::copy_destination}});
    commands.copy(rhi::BufferToTexture{stand_in_.handle, table_.handle});
    move(commands, {{&table_, rhi::State::sampled}});
}

void AerialPerspectivePass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps,
                                   std::uint32_t index) {
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, pipeline_, bindings_, invocations_);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
