#include "models/bruneton/solution.h"

#include "models/bruneton/extents.h"
#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <bit>

namespace aureole::detail {
namespace {

constexpr rhi::Usage work_usage = rhi::Usage::sampled | rhi::Usage::storage;

std::uint32_t unsigned_of(int value) { return static_cast<std::uint32_t>(value); }

}  // namespace

rhi::Format small_table_format(const rhi::Device& device) {
    const bool filtered = device.format_support(rhi::Format::rgba32_float, rhi::Dimension::d2).linear_filter;
    return filtered ? rhi::Format::rgba32_float : rhi::Format::rgba16_float;
}

BrunetonSolution::BrunetonSolution(AirResources& shared, const models::BrunetonSettings& settings, bool combined)
    : shared_(shared),
      settings_(settings),
      combined_(combined),
      layers_(combined ? 1 : 1 + std::popcount(shared.air.sharp_phases)),
      slices_(settings.altitude_nodes) {
    const BrunetonDirections directions = bruneton_directions(settings);
    zenith_nodes_ = directions.zenith_nodes;
    azimuth_nodes_ = directions.azimuth_nodes;
    Objects& objects = shared.objects;
    arriving_ = objects.texture(
        {"bruneton field", rhi::Dimension::d3, rhi::Format::rgba32_float, bruneton_field_extent(settings), work_usage});
    source_ = objects.texture(
        {"bruneton source", rhi::Dimension::d3, settings.format, bruneton_scattering_extent(settings), work_usage});
    ray_rule_ = quadrature_block(settings.ray_nodes);
    zenith_rule_ = quadrature_block(zenith_nodes_);
    ray_quadrature_ = objects.constants("bruneton ray quadrature", sizeof ray_rule_);
    zenith_quadrature_ = objects.constants("bruneton zenith quadrature", sizeof zenith_rule_);

    first_scattering_ = objects.compute(shaders::bruneton_single, specialize().values());
    next_scattering_ = objects.compute(shaders::bruneton_scattering, specialize().values());
    // Single scattering alone: the sky's light on the ground would be reflected by the second.
    const int zenith_nodes = settings.orders > 1 ? zenith_nodes_ : 0;
    irradiance_ = objects.compute(shaders::bruneton_irradiance, specialize().set(12, zenith_nodes).values());
    arriving_pipeline_ = objects.compute(shaders::bruneton_arriving, specialize().values());
    density_ = objects.compute(shaders::bruneton_density, specialize().values());
}

Specialize BrunetonSolution::specialize() const {
    // Degrees of the phase functions and of the field multiply: beyond half of what the azimuths resolve, sums would fold over.
    Specialize values(shared_.air);
    values.set(8, settings_.ray_nodes)
        .set(12, zenith_nodes_)
        .set(13, azimuth_nodes_)
        .set(14, std::clamp(azimuth_nodes_ - 1, 2, 11))
        .set(32, settings_.sampling == models::BrunetonSampling::published);
    for (const rhi::Specialization& value : look_up()) values.set(value);
    return values;
}

std::vector<rhi::Specialization> BrunetonSolution::look_up() const {
    return {{30, unsigned_of(settings_.nu_nodes)}, {31, combined_ ? 1U : 0U}};
}

BrunetonTables BrunetonSolution::make_tables(Objects& objects, TrackedTexture& transmittance, rhi::Usage more) const {
    rhi::Extent size = source_.extent;
    size.depth *= unsigned_of(layers_);
    BrunetonTables tables{&transmittance, {}, {}};
    tables.scattering = objects.texture({"bruneton scattering", rhi::Dimension::d3, settings_.format, size, work_usage | more});
    tables.irradiance = objects.texture({"bruneton irradiance", rhi::Dimension::d2, small_table_format(objects.device()),
                                         settings_.irradiance, work_usage | more});
    return tables;
}

BrunetonSolution::Bindings BrunetonSolution::bind(const AirResources& from, const BrunetonTables& tables) const {
    const rhi::Binding air{0, {}, {}, from.block.handle};
    const rhi::Binding rays{1, {}, {}, ray_quadrature_.handle}, zeniths{1, {}, {}, zenith_quadrature_.handle};
    const rhi::Binding profiles{2, from.profile_table.handle, shared_.nearest, {}};
    const rhi::Binding scattering{2, tables.scattering.handle, shared_.linear, {}};
    const rhi::Binding transmittance{3, tables.transmittance->handle, shared_.linear, {}};
    const rhi::Binding irradiance{4, tables.irradiance.handle, shared_.linear, {}};
    const rhi::Binding phases{7, from.phase_table.handle, shared_.nearest, {}};
    const auto set = [&](const char* name, rhi::Pipeline pipeline, const rhi::Shader& shader,
                         std::initializer_list<rhi::Binding> slots) {
        std::vector<rhi::Binding> used;
        for (const rhi::Binding& binding : slots)
            if (std::ranges::any_of(shader.slots, [&](const rhi::SlotDesc& slot) { return slot.slot == binding.slot; }))
                used.push_back(binding);
        return from.objects.bindings(name, pipeline, used);
    };
    const rhi::Binding source{4, source_.handle, shared_.linear, {}};
    const rhi::Binding scattering_out{6, tables.scattering.handle, {}, {}};
    Bindings sets;
    sets.first_scattering = set("bruneton single", first_scattering_, shaders::bruneton_single,
                                {air, rays, profiles, transmittance, scattering_out, phases});
    sets.next_scattering = set("bruneton scattering", next_scattering_, shaders::bruneton_scattering,
                               {air, rays, profiles, transmittance, source, scattering_out, phases});
    sets.irradiance = set("bruneton irradiance", irradiance_, shaders::bruneton_irradiance,
                          {air, zeniths, scattering, transmittance, {6, tables.irradiance.handle, {}, {}}, phases});
    sets.arriving = set("bruneton field", arriving_pipeline_, shaders::bruneton_arriving,
                        {air, zeniths, scattering, transmittance, irradiance, {6, arriving_.handle, {}, {}}, phases});
    sets.density =
        set("bruneton density", density_, shaders::bruneton_density,
            {air, zeniths, profiles, {4, arriving_.handle, shared_.nearest, {}}, {6, source_.handle, {}, {}}, phases});
    return sets;
}

void BrunetonSolution::invalidate() noexcept {
    forget(arriving_);
    forget(source_);
    forget(ray_quadrature_);
    forget(zenith_quadrature_);
    start();
}

BrunetonSolution::Position BrunetonSolution::position() const noexcept {
    if (done_ < slices_) return {Stage::scattering, 1, done_, slices_ - done_};
    const int per_order = 2 * slices_ + 1;
    const int order = 2 + (done_ - slices_) / per_order, unit = (done_ - slices_) % per_order;
    if (unit == 0) return {Stage::field, order, 0, 1};
    if (unit <= slices_) return {Stage::density, order, unit - 1, slices_ - unit + 1};
    return {Stage::scattering, order, unit - slices_ - 1, per_order - unit};
}

void BrunetonSolution::advance(rhi::CommandList& commands, PassScope& scope, PassReport& report, BrunetonTables& tables,
                               const Bindings& sets, int units) {
    if (ray_quadrature_.state == rhi::State::undefined) {
        update_block(commands, ray_quadrature_, ray_rule_);
        update_block(commands, zenith_quadrature_, zenith_rule_);
    }
    while (units > 0 && !finished()) {
        const Position at = position();
        const int count = std::min(units, at.left);
        const bool last_of_stage = count == at.left;
        const glm::vec4 first(static_cast<float>(at.slice), 0, 0, 0);
        const auto push = std::as_bytes(std::span(&first, 1));
        rhi::Extent part = source_.extent;
        part.depth = unsigned_of(count);
        if (at.stage == Stage::field) {
            record_field(commands, scope, tables, sets, at.order);
            report.bytes_written += arriving_.bytes + tables.irradiance.bytes * (at.order == 2 ? 2 : 1);
        } else {
            const bool density = at.stage == Stage::density;
            TrackedTexture& out = density ? source_ : tables.scattering;
            move(commands, {{&out, rhi::State::storage_write}});
            if (density)
                scope.dispatch(shaders::bruneton_density, density_, sets.density, part, push);
            else if (at.order == 1)
                scope.dispatch(shaders::bruneton_single, first_scattering_, sets.first_scattering, part, push);
            else
                scope.dispatch(shaders::bruneton_scattering, next_scattering_, sets.next_scattering, part, push);
            if (last_of_stage) move(commands, {{&out, rhi::State::sampled}});
            report.bytes_written += out.bytes / unsigned_of(slices_) * unsigned_of(count);
        }
        units -= count;
        done_ += count;
    }
    if (finished() && settings_.orders == 1) record_irradiance(commands, scope, tables, sets, 0);
}

void BrunetonSolution::record_irradiance(rhi::CommandList& commands, PassScope& scope, BrunetonTables& tables,
                                         const Bindings& sets, float share) {
    move(commands, {{&tables.irradiance, rhi::State::storage_write}});
    const glm::vec4 push(share, 0, 0, 0);
    scope.dispatch(shaders::bruneton_irradiance, irradiance_, sets.irradiance, tables.irradiance.extent,
                   std::as_bytes(std::span(&push, 1)));
    move(commands, {{&tables.irradiance, rhi::State::sampled}});
}

void BrunetonSolution::record_field(rhi::CommandList& commands, PassScope& scope, BrunetonTables& tables, const Bindings& sets,
                                    int order) {
    // What arrives from the ground has been scattered once less than what arrives from the air, as it was reflected once more.
    if (order == 2) record_irradiance(commands, scope, tables, sets, 0);
    move(commands, {{&arriving_, rhi::State::storage_write}});
    scope.dispatch(shaders::bruneton_arriving, arriving_pipeline_, sets.arriving, arriving_.extent);
    move(commands, {{&arriving_, rhi::State::sampled}});
    record_irradiance(commands, scope, tables, sets, 1);
}

}  // namespace aureole::detail
