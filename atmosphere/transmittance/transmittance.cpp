#include "transmittance/transmittance.h"

#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {

TransmittancePass::TransmittancePass(AirResources& shared) {
    Objects& objects = shared.objects;
    const QualitySettings& quality = shared.quality;
    const bool published = quality.sampling == Sampling::published_2020;
    table_ = objects.texture({"transmittance", rhi::Dimension::d2, quality.table_format, quality.transmittance,
                              rhi::Usage::sampled | rhi::Usage::storage | rhi::Usage::copy_source});
    shader_ = published ? &shaders::transmittance_2020 : &shaders::transmittance;
    pipeline_ = objects.compute(*shader_, Specialize(shared.air).set(8, quality.transmittance_nodes).values());
    const rhi::Binding air{0, {}, {}, shared.block.handle};
    const rhi::Binding profiles{2, shared.profile_table.handle, shared.nearest, {}};
    const rhi::Binding out{3, table_.handle, {}, {}};
    if (published) {
        bindings_ = objects.bindings("transmittance", pipeline_, {air, profiles, out});
    } else {
        rule_ = quadrature_block(quality.transmittance_nodes);
        quadrature_ = objects.constants("transmittance quadrature", sizeof rule_);
        bindings_ = objects.bindings("transmittance", pipeline_, {air, {1, {}, {}, quadrature_.handle}, profiles, out});
    }
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
