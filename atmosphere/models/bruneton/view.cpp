#include "models/bruneton/bruneton.h"

#include "module/requirements.h"
#include "sky_view/sky_view.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>

namespace aureole::detail {
namespace {

constexpr std::array<std::string_view, 1> view_passes{"view_table"};
constexpr std::uint32_t from_space_constant = 42;

/// Parts into which the view table splits the 4D table's steps of nu. The air's light needs one.
constexpr std::uint32_t nu_parts = 4;

}  // namespace

BrunetonView::BrunetonView(ViewResources& shared, const ViewSettings& settings, const models::BrunetonSettings& model,
                           const BrunetonTables& tables, const std::vector<rhi::Specialization>& look_up) {
    Objects& objects = shared.objects;
    const std::uint32_t layers = layers_with_sharp_phases(shared.air.air);
    const auto rows = static_cast<std::uint32_t>(model.view_nodes), nus = static_cast<std::uint32_t>(model.nu_nodes);
    require_rows("bruneton.view_nodes", rows, shared.suns, layers, "device.max_texture_2d",
                 objects.device().capabilities().max_texture_2d);
    const rhi::Format format = small_table_format(objects.device());
    constexpr rhi::Usage usage = rhi::Usage::sampled | rhi::Usage::storage;
    table_ = objects.texture(
        {"bruneton view table", rhi::Dimension::d2, format, {(nus - 1) * nu_parts + 1, rows * layers * shared.suns, 1}, usage});
    depth_ = objects.texture({"bruneton view depth", rhi::Dimension::d2, format, {model.transmittance.width, 1, 1}, usage});
    // The strip is written by the first invocations of each of its rows.
    const std::uint32_t strip_rows = (depth_.extent.width + table_.extent.width - 1) / table_.extent.width;
    invocations_ = {table_.extent.width, std::max(rows, strip_rows), shared.suns};

    Specialize values = shared.specialize();
    for (const rhi::Specialization& value : look_up) values.set(value);
    pipeline_ = objects.compute(shaders::bruneton_view_table, values.values());
    kernels_ = {.composite = &shaders::bruneton_composite,
                .composite_raster = &shaders::bruneton_composite_raster,
                .light = &shaders::bruneton_light,
                .tables = {{2, tables.scattering.handle, shared.air.linear, {}},
                           {3, tables.transmittance->handle, shared.air.linear, {}},
                           {4, tables.irradiance.handle, shared.air.linear, {}}},
                .specialization = look_up,
                .space_constant = from_space_constant,
                .aerial_perspective = settings.aerial_perspective};
    std::vector<rhi::Binding> slots = kernels_.tables;
    slots.insert(slots.end(), {{0, {}, {}, shared.air.block.handle},
                               {1, {}, {}, shared.block.handle},
                               {6, table_.handle, {}, {}},
                               {7, shared.air.phase_table.handle, shared.air.nearest, {}},
                               {9, depth_.handle, {}, {}}});
    bindings_ = objects.bindings("bruneton view table", pipeline_, bindings_of(shaders::bruneton_view_table, slots));
    kernels_.tables.push_back({11, table_.handle, shared.air.linear, {}});
    kernels_.tables.push_back({17, depth_.handle, shared.air.linear, {}});
}

std::span<const std::string_view> BrunetonView::passes() const noexcept { return view_passes; }

void BrunetonView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    from_space_ = fresh.camera.w > 0.5F;
    stale_ |= fresh.camera.x != before.camera.x || fresh.camera.w != before.camera.w;
    for (int sun = 0; sun < max_suns; ++sun) stale_ |= fresh.sun_direction[sun].w != before.sun_direction[sun].w;
}

void BrunetonView::invalidate() noexcept {
    forget(table_);
    forget(depth_);
    stale_ = true;
}

void BrunetonView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    if (!due()) return;
    PassScope scope(commands, reports[0], timestamps, 0);
    move(commands, {{&table_, rhi::State::storage_write}, {&depth_, rhi::State::storage_write}});
    scope.dispatch(shaders::bruneton_view_table, pipeline_, bindings_, invocations_);
    move(commands, {{&table_, rhi::State::sampled}, {&depth_, rhi::State::sampled}});
    reports[0].bytes_written = table_.bytes + depth_.bytes;
    stale_ = from_space_;
}

}  // namespace aureole::detail
