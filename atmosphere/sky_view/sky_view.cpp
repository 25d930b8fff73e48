#include "sky_view/sky_view.h"

#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

#include <bit>

namespace aureole::detail {

Specialize ViewResources::specialize() const {
    const bool published = air.quality.sampling == Sampling::published_2020;
    Specialize values(air.air);
    values.set(6, static_cast<int>(suns))
        .set(7, published)
        .set(9, air.quality.angular_order)
        .set(24, static_cast<int>(projection));
    // The published tables hold all phase functions applied.
    if (published) values.set(5, 0);
    return values;
}

std::uint32_t ViewResources::layers_per_sun() const {
    if (air.quality.sampling == Sampling::published_2020) return 1;
    return 1 + static_cast<std::uint32_t>(std::popcount(air.air.sharp_phases));
}

SkyViewKey SkyViewKey::of(const ViewBlock& block) {
    SkyViewKey key{block.camera, block.space, glm::vec4(block.froxels.z), {}};
    for (int sun = 0; sun < max_suns; ++sun) key.suns[sun] = {block.sun_direction[sun].w, block.sun_azimuth[sun].w};
    return key;
}

SkyViewPass::SkyViewPass(ViewResources& shared) {
    const QualitySettings& quality = shared.air.quality;
    shader_ = quality.sampling == Sampling::published_2020 ? &shaders::sky_view_2020 : &shaders::sky_view;
    const rhi::Extent extent{quality.sky_view.width, quality.sky_view.height * (shared.suns * shared.layers_per_sun() + 1), 1};
    invocations_ = {extent.width, quality.sky_view.height * shared.suns, 1};
    table_ = shared.objects.texture(
        {"sky_view", rhi::Dimension::d2, quality.table_format, extent, rhi::Usage::sampled | rhi::Usage::storage});
    create(shared, low_, quality.sky_view_nodes);
    create(shared, high_, quality.sampling == Sampling::gauss ? quality.sky_view_space_nodes : quality.sky_view_nodes);
}

void SkyViewPass::create(ViewResources& shared, Variant& variant, int nodes) {
    Objects& objects = shared.objects;
    variant.pipeline = objects.compute(*shader_, shared.specialize().set(8, nodes).values());
    const rhi::Binding air{0, {}, {}, shared.air.block.handle};
    const rhi::Binding profiles{2, shared.air.profile_table.handle, shared.air.nearest, {}};
    const rhi::Binding transmittance{3, shared.transmittance.handle, shared.air.linear, {}};
    const rhi::Binding multi_scatter{4, shared.multi_scatter.handle, shared.air.linear, {}};
    const rhi::Binding view{5, {}, {}, shared.block.handle};
    const rhi::Binding out{6, table_.handle, {}, {}};
    const rhi::Binding phases{7, shared.air.phase_table.handle, shared.air.nearest, {}};
    if (shader_ == &shaders::sky_view_2020) {
        variant.bindings =
            objects.bindings("sky_view", variant.pipeline, {air, profiles, transmittance, multi_scatter, view, out, phases});
        return;
    }
    variant.rule = quadrature_block(nodes);
    variant.quadrature = objects.constants("sky_view quadrature", sizeof variant.rule);
    const rhi::Binding quadrature{1, {}, {}, variant.quadrature.handle};
    variant.bindings = objects.bindings("sky_view", variant.pipeline,
                                        {air, quadrature, profiles, transmittance, multi_scatter, view, out, phases});
}

bool has_long_rays(const ViewBlock& view, const Planet& planet) {
    return 1e3 * static_cast<double>(view.camera.x) > 0.4 * (planet.top_radius_m - planet.bottom_radius_m);
}

void SkyViewPass::record(rhi::CommandList& commands, bool long_rays, PassReport& report, TimestampSlots timestamps,
                         std::uint32_t index) {
    Variant& variant = long_rays ? high_ : low_;
    if (variant.quadrature.handle && variant.quadrature.state == rhi::State::undefined)
        update_block(commands, variant.quadrature, variant.rule);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, variant.pipeline, variant.bindings, invocations_);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
