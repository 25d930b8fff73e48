#include "models/hillaire/psi.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {
namespace {

constexpr rhi::Usage table_usage = rhi::Usage::sampled | rhi::Usage::storage;

}  // namespace

HillaireMultiScatterPass::HillaireMultiScatterPass(AirResources& shared, TrackedTexture& transmittance,
                                                   const models::HillaireSettings& settings) {
    Objects& objects = shared.objects;
    const rhi::Extent size = settings.multi_scatter;
    rays_ = objects.texture(
        {"multi_scatter rays", rhi::Dimension::d2, rhi::Format::rgba32_float, hillaire_rays_extent(settings), table_usage});
    table_ = objects.texture({"multi_scatter", rhi::Dimension::d2, settings.table_format, size, table_usage});
    rays_pipeline_ = objects.compute(
        shaders::hillaire_multi_scatter_rays,
        Specialize(shared.air).set(8, settings.multi_scatter_steps).set(15, static_cast<int>(size.width)).values());
    sum_pipeline_ = objects.compute(shaders::hillaire_multi_scatter, {});
    rays_bindings_ = objects.bindings("multi_scatter rays", rays_pipeline_,
                                      {{0, {}, {}, shared.block.handle},
                                       {2, shared.profile_table.handle, shared.nearest, {}},
                                       {3, transmittance.handle, shared.linear, {}},
                                       {6, rays_.handle, {}, {}}});
    sum_bindings_ =
        objects.bindings("multi_scatter", sum_pipeline_, {{2, rays_.handle, shared.nearest, {}}, {6, table_.handle, {}, {}}});
}

void HillaireMultiScatterPass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps,
                                      std::uint32_t index) {
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&rays_, rhi::State::storage_write}});
    scope.dispatch(shaders::hillaire_multi_scatter_rays, rays_pipeline_, rays_bindings_,
                   {rays_.extent.width, rays_.extent.height / 2, 1});
    move(commands, {{&rays_, rhi::State::sampled}, {&table_, rhi::State::storage_write}});
    scope.dispatch(shaders::hillaire_multi_scatter, sum_pipeline_, sum_bindings_, table_.extent);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = rays_.bytes + table_.bytes;
}

}  // namespace aureole::detail
