#include "light/light.h"

#include "quadrature/gauss_legendre.h"

namespace aureole::detail {

// Phase functions up to degree 8: with 12 azimuths, degrees from 10 on would be taken for those that are wanted.
Specialize light_specialization(const ViewResources& shared) { return shared.specialize().set(14, 8); }

LightPass::LightPass(ViewResources& shared, const ModelKernels& kernels, bool enabled) : enabled_(enabled) {
    if (!enabled) return;
    Objects& objects = shared.objects;
    const auto table = [&](const char* name, rhi::Usage more) {
        return objects.texture({name,
                                rhi::Dimension::d2,
                                rhi::Format::rgba32_float,
                                {10, shared.suns, 1},
                                rhi::Usage::sampled | rhi::Usage::storage | more});
    };
    table_ = table("light", rhi::Usage::copy_source);
    rule_ = quadrature_block(light_zeniths);
    quadrature_ = objects.constants("light quadrature", sizeof rule_);
    const std::vector<TripletKernels> runs = runs_of(shared, kernels);
    while (sums_.size() < sums_between(runs.size())) sums_.push_back(table("light sum", {}));
    for (const TripletKernels& run : runs) {
        Specialize values = light_specialization(*run.shared);
        for (const rhi::Specialization& value : run.kernels->specialization) values.set(value);
        runs_.push_back({run.kernels->light, objects.compute(*run.kernels->light, values.values()), {}});
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const AirResources& air = runs[i].shared->air;
        std::vector<rhi::Binding> slots = runs[i].kernels->tables;
        slots.insert(slots.end(), {{0, {}, {}, air.block.handle},
                                   {1, {}, {}, shared.block.handle},
                                   {7, air.phase_table.handle, air.nearest, {}},
                                   {8, {}, {}, quadrature_.handle},
                                   {9, written_by(i).handle, {}, {}},
                                   {10, air.profile_table.handle, air.nearest, {}},
                                   runs[i].shared->triplet_binding(),
                                   {14, i > 0 ? written_by(i - 1).handle : air.profile_table.handle, air.nearest, {}}});
        runs_[i].bindings = objects.bindings("light", runs_[i].pipeline, bindings_of(*runs_[i].shader, slots));
    }
}

void LightPass::record(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index) {
    if (quadrature_.state == rhi::State::undefined) update_block(commands, quadrature_, rule_);
    PassScope scope(commands, report, timestamps, index);
    report.bytes_written = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        TrackedTexture& table = written_by(i);
        move(commands, {{&table, rhi::State::storage_write}});
        scope.dispatch(*runs_[i].shader, runs_[i].pipeline, runs_[i].bindings, table.extent);
        move(commands, {{&table, rhi::State::sampled}});
        report.bytes_written += table.bytes;
    }
}

}  // namespace aureole::detail
