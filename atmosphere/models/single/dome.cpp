#include "models/single/dome.h"

#include "module/requirements.h"
#include "sky_view/sky_view.h"

namespace aureole::detail {
namespace {

rhi::TextureDesc table_desc(const ViewResources& shared, const std::string& field, const models::Dome& dome) {
    const bool sharp = dome.phase == models::Dome::Phase::at_look_up;
    const std::uint32_t layers = sharp ? layers_with_sharp_phases(shared.air.air) : 1;
    require_rows(field + ".size.height", dome.size.height, shared.suns, layers, "device.max_texture_2d",
                 shared.objects.device().capabilities().max_texture_2d);
    return {"dome",
            rhi::Dimension::d2,
            dome.format,
            {dome.size.width, dome.size.height * (shared.suns * layers + 1), 1},
            rhi::Usage::sampled | rhi::Usage::storage};
}

}  // namespace

DomePass::DomePass(ViewResources& shared, const std::string& field, const models::Dome& dome, const rhi::Shader& kernel,
                   std::span<const rhi::Binding> bindings, std::span<const rhi::Specialization> specialization)
    : shader_(&kernel),
      invocations_{dome.size.width, dome.size.height * shared.suns, 1},
      table_(shared.objects.texture(table_desc(shared, field, dome))) {
    Specialize values = shared.specialize();
    for (const rhi::Specialization& value : specialization) values.set(value);
    values.storing(dome.format);
    pipeline_ = shared.objects.compute(kernel, values.values());
    std::vector<rhi::Binding> slots(bindings.begin(), bindings.end());
    slots.insert(slots.end(), {{0, {}, {}, shared.air.block.handle},
                               {1, {}, {}, shared.block.handle},
                               {7, shared.air.phase_table.handle, shared.air.nearest, {}},
                               {9, table_.handle, {}, {}},
                               {10, shared.air.profile_table.handle, shared.air.nearest, {}}});
    bindings_ = shared.objects.bindings("dome", pipeline_, bindings_of(kernel, slots));
}

void DomePass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    PassScope scope(commands, report, timestamps, index);
    move(commands, {{&table_, rhi::State::storage_write}});
    scope.dispatch(*shader_, pipeline_, bindings_, invocations_);
    move(commands, {{&table_, rhi::State::sampled}});
    report.bytes_written = table_.bytes;
}

}  // namespace aureole::detail
