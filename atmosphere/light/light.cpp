#include "light/light.h"

#include "quadrature/gauss_legendre.h"

namespace aureole::detail {

// Phase functions up to degree 8: with 12 azimuths, degrees from 10 on would be taken for those that are wanted.
Specialize light_specialization(const ViewResources& shared) { return shared.specialize().set(14, 8); }

LightPass::LightPass(ViewResources& shared, const ModelKernels& kernels, bool enabled)
    : enabled_(enabled), shader_(kernels.light) {
    if (!enabled) return;
    Objects& objects = shared.objects;
    table_ = objects.texture({"light",
                              rhi::Dimension::d2,
                              rhi::Format::rgba32_float,
                              {10, shared.suns, 1},
                              rhi::Usage::sampled | rhi::Usage::storage | rhi::Usage::copy_source});
    rule_ = quadrature_block(light_zeniths);
    quadrature_ = objects.constants("light quadrature", sizeof rule_);
    Specialize values = light_specialization(shared);
    for (const rhi::Specialization& value : kernels.specialization) values.set(value);
    pipeline_ = objects.compute(*shader_, values.values());
    std::vector<rhi::Binding> slots = kernels.tables;
    slots.insert(slots.end(), {{0, {}, {}, shared.air.block.handle},
                               {1, {}, {}, shared.block.handle},
                               {7, shared.air.phase_table.handle, shared.air.nearest, {}},
                               {8, {}, {}, quadrature_.handle},
                               {9, table_.handle, {}, {}},
                               {10, shared.air.profile_table.handle, shared.air.nearest, {}}});
    bindings_ = objects.bindings("light", pipeline_, bindings_of(*shader_, slots));
}

void LightPass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    if (quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, pipeline_, bindings_, table_.extent);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
