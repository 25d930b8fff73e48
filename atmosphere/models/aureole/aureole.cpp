#include "models/aureole/aureole.h"

#include "module/requirements.h"
#include "multi_scatter/angular_order.h"
#include "multi_scatter/order_ratio.h"

#include <aureole/models/aureole.h>

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>

namespace aureole {
namespace detail {
namespace {

constexpr std::array<std::string_view, 2> air_passes{"transmittance", "multi_scatter"};
constexpr std::array<std::string_view, 2> view_passes{"sky_view", "aerial_perspective"};

class AureoleModel final : public Model {
public:
    explicit AureoleModel(const QualitySettings& quality) : quality_(quality) { AureoleModel::validate(); }
    [[nodiscard]] std::string_view name() const noexcept override { return "aureole"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return quality_; }
    [[nodiscard]] QualitySettings quality_for(const AtmosphereParameters& parameters) const override {
        QualitySettings result = quality_;
        if (quality_.multi_scatter_orders == 0) return result;
        // What each scattering loses between the nodes is lost as often as light is scattered.
        if (order_ratio(parameters, quality_.ground_light) > slow_order_ratio)
            result.multi_scatter_later_nodes = std::max(result.multi_scatter_later_nodes, result.multi_scatter_nodes);
        if (!quality_.angular_order_as_needed) return result;
        result.angular_order = angular_order_for(parameters, quality_.angular_order);
        // Directions that tell the moments apart.
        result.multi_scatter_zenith = std::max(result.multi_scatter_zenith, result.angular_order + 2);
        result.multi_scatter_azimuth = std::max(result.multi_scatter_azimuth, result.angular_order + 2);
        return result;
    }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters& parameters) const override {
        const QualitySettings q = quality_for(parameters);
        const auto count = [](int value) { return std::to_string(value); };
        std::vector<ModelTable> tables{
            {"transmittance table", q.transmittance, q.table_format, count(q.transmittance_nodes) + " nodes a ray"}};
        if (q.multi_scatter_orders > 0)
            tables.push_back({"multi-scatter table", q.multi_scatter, rhi::Format::rgba32_float,
                              "moments to order " + count(q.angular_order) + ", " +
                                  count(passes_for(order_ratio(parameters, q.ground_light), q.multi_scatter_orders)) +
                                  " passes, " + count(2 * q.multi_scatter_zenith * q.multi_scatter_azimuth) + " rays of " +
                                  count(q.multi_scatter_nodes) + " and " + count(q.multi_scatter_later_nodes) + " nodes"});
        tables.push_back({"sky-view table", q.sky_view, q.table_format, count(q.sky_view_nodes) + " nodes a segment"});
        tables.push_back(
            {"froxels", q.aerial_perspective, q.froxel_format, count(q.aerial_perspective_nodes) + " slabs a slice"});
        return tables;
    }
    void validate() const override { aureole::validate(quality_); }
    [[nodiscard]] bool by_tables() const noexcept override { return true; }
    void require(const rhi::Device& device) const override { require_tables(device, quality_); }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared,
                                                     const AtmosphereParameters& parameters) const override {
        return std::make_unique<AureoleAir>(shared, parameters);
    }

private:
    QualitySettings quality_;
};

TableViewResources checked(const ViewResources& shared, const ViewSettings& settings, TrackedTexture& transmittance,
                           TrackedTexture* multi_scatter) {
    const QualitySettings& quality = shared.air.quality;
    const std::uint32_t layers = layers_with_sharp_phases(shared.air.air);
    const ViewTableSizes sizes{quality.sky_view.height, settings.aerial_perspective ? quality.aerial_perspective.height : 0};
    require_view(shared.objects.device(), "aureole", sizes, shared.suns, layers);
    // Without a table any one that is readable stands in its slot. 11: MULTIPLE_SCATTERING.
    return {shared,
            transmittance,
            multi_scatter != nullptr ? *multi_scatter : transmittance,
            layers,
            {{11, multi_scatter != nullptr ? 1U : 0U}}};
}

}  // namespace

AureoleAir::AureoleAir(AirResources& shared, const AtmosphereParameters& parameters)
    : shared_(shared), transmittance_(shared, transmittance_kernel(shared.quality)) {
    if (shared.quality.multi_scatter_orders > 0)
        multi_scatter_.emplace(shared, transmittance_.table(), order_ratio(parameters, shared.quality.ground_light));
}

std::span<const std::string_view> AureoleAir::passes() const noexcept {
    return std::span(air_passes).first(multi_scatter_ ? 2 : 1);
}

void AureoleAir::complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept {
    block.sun_mapping = sun_mapping(parameters.planet);
}

void AureoleAir::restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) {
    const bool same_axes =
        fresh.radii == before.radii && fresh.sun_mapping == before.sun_mapping && fresh.tables.z == before.tables.z;
    if (multi_scatter_) multi_scatter_->restart(order_ratio(parameters, shared_.quality.ground_light), same_axes);
    transmittance_stale_ = true;
}

void AureoleAir::invalidate() noexcept {
    transmittance_.invalidate();
    if (multi_scatter_) multi_scatter_->invalidate();
    transmittance_stale_ = true;
}

bool AureoleAir::record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                        TimestampSlots timestamps) {
    bool changed = transmittance_stale_;
    if (transmittance_stale_) transmittance_.record(commands, reports[0], timestamps, 0);
    transmittance_stale_ = false;
    if (solving()) changed |= multi_scatter_->record(commands, block, passes_per_frame_, reports[1], timestamps, 1);
    return changed;
}

bool AureoleAir::ready() const noexcept {
    const TrackedTexture& last = multi_scatter_ ? multi_scatter_->table() : transmittance_.table();
    return last.state != rhi::State::undefined;
}

void AureoleAir::spread(int passes_per_frame, bool /*first_too*/) {
    if (multi_scatter_) multi_scatter_->keep_copy(passes_per_frame > 0);
    passes_per_frame_ = passes_per_frame;
}

std::unique_ptr<ModelView> AureoleAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    return std::make_unique<AureoleView>(shared, settings, transmittance_.table(),
                                         multi_scatter_ ? &multi_scatter_->table() : nullptr);
}

AureoleView::AureoleView(ViewResources& shared, const ViewSettings& settings, TrackedTexture& transmittance,
                         TrackedTexture* multi_scatter)
    : shared_(checked(shared, settings, transmittance, multi_scatter)),
      sky_view_(shared_, {&shaders::sky_view, shared.air.quality.sky_view, shared.air.quality.table_format,
                          shared.air.quality.sky_view_nodes}),
      froxels_(shared_,
               {&shaders::aerial_perspective, shared.air.quality.aerial_perspective, shared.air.quality.froxel_format,
                shared.air.quality.aerial_perspective_nodes},
               FroxelWork::column, settings.aerial_perspective),
      kernels_{.composite = &shaders::composite,
               .composite_raster = &shaders::composite_raster,
               .light = &shaders::light,
               .tables = {{2, sky_view_.table().handle, shared.air.linear, {}},
                          {3, transmittance.handle, shared.air.linear, {}},
                          {4, froxels_.table().handle, shared.air.linear, {}}},
               .specialization = {},
               .aerial_perspective = settings.aerial_perspective} {}

std::span<const std::string_view> AureoleView::passes() const noexcept { return view_passes; }

void AureoleView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    sky_stale_ |= !(SkyViewKey::of(fresh) == SkyViewKey::of(before));
    froxels_stale_ |= !same_froxels(before, fresh);
}

void AureoleView::invalidate() noexcept {
    sky_view_.invalidate();
    froxels_.invalidate();
    restart();
}

void AureoleView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    froxels_.prepare(commands);
    if (sky_stale_) sky_view_.record(commands, reports[0], timestamps, 0);
    if (froxels_stale_ && froxels_.enabled()) froxels_.record(commands, reports[1], timestamps, 1);
    sky_stale_ = froxels_stale_ = false;
}

bool AureoleView::ready() const noexcept { return sky_view_.table().state != rhi::State::undefined; }

std::vector<LightTexture> AureoleView::light_textures() { return sky_and_froxels(shared_, &sky_view_, froxels_); }

}  // namespace detail

namespace models {

ModelPtr aureole(const QualitySettings& quality) { return std::make_shared<detail::AureoleModel>(quality); }

}  // namespace models
}  // namespace aureole
