#include "shadows/shadows.h"

#include "common/check.h"
#include "module/requirements.h"
#include "quadrature/gauss_legendre.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace aureole::detail {
namespace {

constexpr int sun_nodes = 8;  // SUN_NODES of shadows_by_quadrature.comp.glsl

/// Of the table: smooth phase functions together, and each sharp one (sky_view_layers of sky_view.glsl).
std::uint32_t layers_of(std::span<const rhi::Specialization> values) {
    for (const rhi::Specialization& value : values)
        if (value.id == 5) return 1 + static_cast<std::uint32_t>(std::popcount(value.bits));
    return 1;
}

void require_size_of(const rhi::Device& device, const rhi::Extent& size, std::uint32_t layers) {
    const std::uint32_t most = device.capabilities().max_texture_2d;
    const auto require = [&](const char* field, std::uint32_t side, std::uint32_t times) {
        if (side * times > most)
            throw Error(ErrorCode::unsupported, field, std::to_string(side),
                        "at most " + std::to_string(most / times) + " (device.max_texture_2d " + std::to_string(most) +
                            ", shared by " + std::to_string(times) + ")");
    };
    require("view.shadows.size.width", size.width, size.depth);
    require("view.shadows.size.height", size.height, layers);
}

}  // namespace

void validate(const ShadowSettings& settings) {
    check("view.shadows.cascades", settings.cascades, 0, ShadowSettings::max_cascades);
    check("view.shadows.distance_m", settings.distance_m, 1e-3, 1e13);
    check("view.shadows.size.width", settings.size.width, 2, 256);
    check("view.shadows.size.height", settings.size.height, 2, 256);
    check("view.shadows.size.depth", settings.size.depth, 2, 256);
    check("view.shadows.samples", settings.samples, 1, 64);
}

void validate(const ShadowMap& map, const ShadowSettings& settings, std::uint32_t max_suns, const rhi::Device& device) {
    constexpr double most = std::numeric_limits<double>::max();
    if (settings.cascades == 0) reject("shadow_map", "a map", "none: ViewSettings::shadows.cascades is 0");
    for (std::uint32_t i = 0; i < settings.cascades; ++i)
        for (std::uint32_t column = 0; column < 4; ++column)
            for (std::uint32_t row = 0; row < 4; ++row)
                check(FieldName("shadow_map.world_to_map")[i][column][row],
                      map.world_to_map[i][static_cast<int>(column)][static_cast<int>(row)], -most, most);
    check("shadow_map.sun", map.sun, 0, max_suns - 1);
    check("shadow_map.bias", map.bias, 0, 1);
    const rhi::TextureDesc* desc = map.texture ? device.find(map.texture) : nullptr;
    if (desc && desc->extent.width % settings.cascades != 0)
        reject("shadow_map.texture", std::to_string(desc->extent.width) + " texels wide",
               "a multiple of " + std::to_string(settings.cascades) + ", the cascades side by side");
}

ShadowBlock pack_shadows(const ShadowMap& map, std::uint32_t cascades, const glm::dvec3& camera_m) {
    Blocks<double>::ShadowBlock block{};
    // The camera's place goes into the matrix in double; what is left for floats is small.
    for (std::uint32_t i = 0; i < cascades; ++i) {
        const glm::dmat4& m = map.world_to_map[i];
        const glm::dvec4 camera = m * glm::dvec4(camera_m, 1);
        for (int row = 0; row < 4; ++row)
            block.world_to_map[4 * i + static_cast<std::uint32_t>(row)] =
                glm::dvec4(1e3 * m[0][row], 1e3 * m[1][row], 1e3 * m[2][row], camera[row]);
        // Nothing is inside of a cascade that has no map.
        if (!map.texture)
            for (std::uint32_t row = 0; row < 4; ++row) block.world_to_map[4 * i + row] = glm::dvec4(0, 0, 0, row == 3 ? 1 : 2);
    }
    block.depth = {map.reversed ? -1 : 1, map.bias, 0, 0};
    return round_block<ShadowBlock>(block);
}

ShadowPass::ShadowPass(ViewResources& shared, const ModelKernels& kernels, const ShadowSettings& settings,
                       rhi::Texture transmittance)
    : shared_(shared), settings_(settings) {
    if (!enabled()) return;
    shader_ = transmittance ? &shaders::shadows : &shaders::shadows_by_quadrature;
    std::vector<TripletKernels> airs = kernels.shadow_triplets;
    if (airs.empty()) airs.push_back({&shared, &kernels, transmittance});
    make_tables(layers_of(specialization(airs.front()).values()), airs.size());
    for (const TripletKernels& air : airs)
        runs_.push_back({air, shared.objects.compute(*shader_, specialization(air).storing(table_.format).values())});
    block_ = shared.objects.constants("shadows", sizeof(ShadowBlock));
    if (!transmittance) {
        rule_ = quadrature_block(sun_nodes);
        nodes_ = shared.objects.constants("shadows quadrature", sizeof rule_);
    }
    use_map({});
}

Specialize ShadowPass::specialization(const TripletKernels& air) const {
    Specialize values = air.shared->specialize();
    for (const rhi::Specialization& value : air.kernels->specialization) values.set(value);
    values.set(39, static_cast<int>(settings_.size.depth)).set(40, static_cast<int>(settings_.cascades));
    return values.set(41, static_cast<int>(settings_.samples));
}

void ShadowPass::make_tables(std::uint32_t layers, std::size_t runs) {
    Objects& objects = shared_.objects;
    require_size_of(objects.device(), settings_.size, layers);
    const bool filtered = objects.device().format_support(rhi::Format::rgba32_float, rhi::Dimension::d2).linear_filter;
    const auto table = [&](const char* name, rhi::Format format) {
        return objects.texture({name,
                                rhi::Dimension::d2,
                                format,
                                {settings_.size.width * settings_.size.depth, settings_.size.height * layers, 1},
                                rhi::Usage::sampled | rhi::Usage::storage});
    };
    table_ = table("shadows", filtered ? rhi::Format::rgba32_float : rhi::Format::rgba16_float);
    while (sums_.size() < sums_between(runs)) sums_.push_back(table("shadows sum", rhi::Format::rgba32_float));
}

void ShadowPass::use_map(rhi::Texture map) {
    if (map_objects_ && map == map_) return;
    auto objects = shared_.objects.sibling();
    std::vector<rhi::BindingSet> bindings;
    for (std::size_t run = 0; run < runs_.size(); ++run) bindings.push_back(bind(*objects, run, map));
    bindings_ = std::move(bindings);
    map_objects_ = std::move(objects);
    map_ = map;
}

rhi::BindingSet ShadowPass::bind(Objects& objects, std::size_t run, rhi::Texture map) {
    const TripletKernels& of = runs_[run].of;
    const AirResources& air = of.shared->air;
    const rhi::Binding slots[] = {{0, {}, {}, air.block.handle},
                                  {1, {}, {}, shared_.block.handle},
                                  {2, {}, {}, block_.handle},
                                  {3, of.transmittance, air.linear, {}},
                                  {4, {}, {}, nodes_.handle},
                                  {5, map ? map : air.profile_table.handle, air.nearest, {}},
                                  {6, written_by(run).handle, {}, {}},
                                  {7, air.phase_table.handle, air.nearest, {}},
                                  {8, run > 0 ? written_by(run - 1).handle : air.profile_table.handle, air.nearest, {}},
                                  {10, air.profile_table.handle, air.nearest, {}},
                                  of.shared->triplet_binding()};
    return objects.bindings("shadows", runs_[run].pipeline, bindings_of(*shader_, slots));
}

void ShadowPass::invalidate() noexcept {
    if (!enabled()) return;
    forget(table_);
    for (TrackedTexture& sum : sums_) forget(sum);
    forget(block_);
    forget(nodes_);
}

void ShadowPass::record(rhi::CommandList& commands, const ShadowBlock& block, PassReport& report, TimestampSlots timestamps,
                        std::uint32_t index) {
    update_block(commands, block_, block);
    if (nodes_.handle && nodes_.state == rhi::State::undefined) update_block(commands, nodes_, rule_);
    PassScope scope(commands, report, timestamps, index);
    report.bytes_written = 0;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        TrackedTexture& table = written_by(run);
        move(commands, {{&table, rhi::State::storage_write}});
        scope.dispatch(*shader_, runs_[run].pipeline, bindings_[run], {settings_.size.width, settings_.size.height, 1});
        move(commands, {{&table, rhi::State::sampled}});
        report.bytes_written += table.bytes;
    }
}

}  // namespace aureole::detail
