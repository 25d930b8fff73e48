#include "transmittance/transmittance.h"

#include "models/model.h"
#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {

TableKernel transmittance_kernel(const QualitySettings& quality) {
    return {&shaders::transmittance, quality.transmittance, quality.table_format, quality.transmittance_nodes};
}

TransmittancePass::TransmittancePass(AirResources& shared, const TableKernel& kernel, rhi::Usage copies)
    : shader_(kernel.shader) {
    Objects& objects = shared.objects;
    table_ = objects.texture(
        {"transmittance", rhi::Dimension::d2, kernel.format, kernel.size, rhi::Usage::sampled | rhi::Usage::storage | copies});
    pipeline_ = objects.compute(*shader_, Specialize(shared.air).set(8, kernel.nodes).storing(kernel.format).values());
    if (kernel.has_quadrature()) {
        rule_ = quadrature_block(kernel.nodes);
        quadrature_ = objects.constants("transmittance quadrature", sizeof rule_);
    }
    const rhi::Binding slots[] = {{0, {}, {}, shared.block.handle},
                                  {1, {}, {}, quadrature_.handle},
                                  {2, shared.profile_table.handle, shared.nearest, {}},
                                  {3, table_.handle, {}, {}}};
    bindings_ = objects.bindings("transmittance", pipeline_, bindings_of(*shader_, slots));
}

void TransmittancePass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    if (quadrature_.handle && quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, pipeline_, bindings_, table_.extent);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
