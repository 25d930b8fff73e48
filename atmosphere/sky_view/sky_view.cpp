#include "sky_view/sky_view.h"

#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {

SkyViewKey SkyViewKey::of(const ViewBlock& block) {
    SkyViewKey key{block.camera, block.space, block.table_exposure, {}};
    for (int sun = 0; sun < max_suns; ++sun) key.suns[sun] = {block.sun_direction[sun].w, block.sun_azimuth[sun].w};
    return key;
}

SkyViewPass::SkyViewPass(TableViewResources& shared) {
    const QualitySettings& quality = shared.air.quality;
    shader_ = quality.sampling == Sampling::published_2020 ? &shaders::sky_view_2020 : &shaders::sky_view;
    const rhi::Extent extent{quality.sky_view.width, quality.sky_view.height * (shared.suns * shared.layers_per_sun() + 1), 1};
    invocations_ = {extent.width, quality.sky_view.height * shared.suns, 1};
    table_ = shared.objects.texture(
        {"sky_view", rhi::Dimension::d2, quality.table_format, extent, rhi::Usage::sampled | rhi::Usage::storage});
    Objects& objects = shared.objects;
    pipeline_ = objects.compute(*shader_, shared.specialize().set(8, quality.sky_view_nodes).values());
    const rhi::Binding air{0, {}, {}, shared.air.block.handle};
    const rhi::Binding profiles{2, shared.air.profile_table.handle, shared.air.nearest, {}};
    const rhi::Binding transmittance{3, shared.transmittance.handle, shared.air.linear, {}};
    const rhi::Binding multi_scatter{4, shared.multi_scatter.handle, shared.air.linear, {}};
    const rhi::Binding view{5, {}, {}, shared.block.handle};
    const rhi::Binding out{6, table_.handle, {}, {}};
    const rhi::Binding phases{7, shared.air.phase_table.handle, shared.air.nearest, {}};
    if (shader_ == &shaders::sky_view_2020) {
        bindings_ = objects.bindings("sky_view", pipeline_, {air, profiles, transmittance, multi_scatter, view, out, phases});
        return;
    }
    rule_ = quadrature_block(quality.sky_view_nodes);
    quadrature_ = objects.constants("sky_view quadrature", sizeof rule_);
    const rhi::Binding quadrature{1, {}, {}, quadrature_.handle};
    bindings_ =
        objects.bindings("sky_view", pipeline_, {air, quadrature, profiles, transmittance, multi_scatter, view, out, phases});
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
