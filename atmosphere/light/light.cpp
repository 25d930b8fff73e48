#include "light/light.h"

#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {
namespace {
constexpr int zenith_nodes = 8;  // LIGHT_ZENITHS of light.comp.glsl
}

LightPass::LightPass(ViewResources& shared, TrackedTexture& sky_view, bool enabled) : enabled_(enabled) {
    if (!enabled) return;
    Objects& objects = shared.objects;
    table_ = objects.texture({"light",
                              rhi::Dimension::d2,
                              rhi::Format::rgba32_float,
                              {10, shared.suns, 1},
                              rhi::Usage::sampled | rhi::Usage::storage | rhi::Usage::copy_source});
    rule_ = quadrature_block(zenith_nodes);
    quadrature_ = objects.constants("light quadrature", sizeof rule_);
    // Phase functions up to degree 8: with 12 azimuths, degrees from 10 on would be taken for those that are wanted.
    pipeline_ = objects.compute(shaders::light, shared.specialize().set(14, 8).values());
    bindings_ = objects.bindings("light", pipeline_,
                                 {{0, {}, {}, shared.air.block.handle},
                                  {1, {}, {}, shared.block.handle},
                                  {2, sky_view.handle, shared.air.linear, {}},
                                  {3, shared.transmittance.handle, shared.air.linear, {}},
                                  {4, {}, {}, quadrature_.handle},
                                  {5, table_.handle, {}, {}},
                                  {7, shared.air.phase_table.handle, shared.air.nearest, {}}});
}

void LightPass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    if (quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(shaders::light, pipeline_, bindings_, table_.extent);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
