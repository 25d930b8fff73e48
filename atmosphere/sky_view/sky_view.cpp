#include "sky_view/sky_view.h"

#include "quadrature/gauss_legendre.h"

#include <bit>

namespace aureole::detail {

SkyViewKey SkyViewKey::of(const ViewBlock& block) {
    SkyViewKey key{block.camera, block.space, block.table_exposure, {}};
    for (int sun = 0; sun < max_suns; ++sun) key.suns[sun] = {block.sun_direction[sun].w, block.sun_azimuth[sun].w};
    return key;
}

Specialize TableViewResources::specialize_tables() const {
    Specialize values = specialize();
    for (const rhi::Specialization& value : specialization) values.set(value);
    return values;
}

std::uint32_t layers_with_sharp_phases(const AirStructure& air) {
    return 1 + static_cast<std::uint32_t>(std::popcount(air.sharp_phases));
}

SkyViewPass::SkyViewPass(TableViewResources& shared, const TableKernel& kernel) : shader_(kernel.shader) {
    Objects& objects = shared.objects;
    const rhi::Extent extent{kernel.size.width, kernel.size.height * (shared.suns * shared.layers_per_sun + 1), 1};
    invocations_ = {extent.width, kernel.size.height * shared.suns, 1};
    table_ =
        objects.texture({"sky_view", rhi::Dimension::d2, kernel.format, extent, rhi::Usage::sampled | rhi::Usage::storage});
    pipeline_ = objects.compute(*shader_, shared.specialize_tables().set(8, kernel.nodes).storing(kernel.format).values());
    if (kernel.has_quadrature()) {
        rule_ = quadrature_block(kernel.nodes);
        quadrature_ = objects.constants("sky_view quadrature", sizeof rule_);
    }
    const rhi::Binding slots[] = {{0, {}, {}, shared.air.block.handle},
                                  {1, {}, {}, quadrature_.handle},
                                  {2, shared.air.profile_table.handle, shared.air.nearest, {}},
                                  {3, shared.transmittance.handle, shared.air.linear, {}},
                                  {4, shared.multi_scatter.handle, shared.air.linear, {}},
                                  {5, {}, {}, shared.block.handle},
                                  {6, table_.handle, {}, {}},
                                  {7, shared.air.phase_table.handle, shared.air.nearest, {}}};
    bindings_ = objects.bindings("sky_view", pipeline_, bindings_of(*shader_, slots));
}

void SkyViewPass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    if (quadrature_.handle && quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, pipeline_, bindings_, invocations_);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
