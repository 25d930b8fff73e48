#include "aerial_perspective/aerial_perspective.h"

#include <array>
#include <cstring>

namespace aureole::detail {

namespace {

ViewBlock for_froxels(ViewBlock block) {
    block.composite = glm::vec4(0);
    for (int sun = 0; sun < max_suns; ++sun)
        block.sun_irradiance[sun] = block.sun_disk[sun] = block.sun_limb[sun] = glm::vec4(0);
    return block;
}

}  // namespace

std::vector<LightTexture> sky_and_froxels(const TableViewResources& shared, SkyViewPass* sky_view,
                                          AerialPerspectivePass& froxels) {
    const std::uint32_t light = shared.suns * shared.layers_per_sun;
    std::vector<LightTexture> textures;
    if (sky_view != nullptr) textures.push_back({&sky_view->table(), light + 1, static_cast<int>(light)});
    if (froxels.enabled()) textures.push_back({&froxels.table(), 1 + light, 0});
    return textures;
}

bool same_froxels(const ViewBlock& a, const ViewBlock& b) {
    const ViewBlock one = for_froxels(a), other = for_froxels(b);
    return std::memcmp(&one, &other, sizeof one) == 0;
}

AerialPerspectivePass::AerialPerspectivePass(TableViewResources& shared, const TableKernel& kernel, FroxelWork work,
                                             bool enabled)
    : enabled_(enabled), shader_(kernel.shader) {
    Objects& objects = shared.objects;
    const rhi::Extent size = kernel.size;
    rhi::Extent extent;
    if (enabled) extent = {size.width, size.height * (1 + shared.suns * shared.layers_per_sun), size.depth};
    const rhi::Usage written = enabled ? rhi::Usage::storage : rhi::Usage::copy_destination;
    table_ = objects.texture({"aerial_perspective", rhi::Dimension::d3, kernel.format, extent, rhi::Usage::sampled | written});
    if (!enabled) {
        const std::array<std::byte, 16> black{};
        stand_in_ = objects.upload("aerial_perspective stand-in", std::span(black.data(), rhi::bytes_per_texel(kernel.format)));
        return;
    }

    invocations_ = {size.width, size.height * shared.suns, work == FroxelWork::froxel ? size.depth : 1};
    pipeline_ = objects.compute(*shader_, shared.specialize_tables().set(8, kernel.nodes).storing(kernel.format).values());
    const rhi::Binding slots[] = {{0, {}, {}, shared.air.block.handle},
                                  {2, shared.air.profile_table.handle, shared.air.nearest, {}},
                                  {3, shared.transmittance.handle, shared.air.linear, {}},
                                  {4, shared.multi_scatter.handle, shared.air.linear, {}},
                                  {5, {}, {}, shared.block.handle},
                                  {6, table_.handle, {}, {}},
                                  {7, shared.air.phase_table.handle, shared.air.nearest, {}}};
    bindings_ = objects.bindings("aerial_perspective", pipeline_, bindings_of(*shader_, slots));
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
