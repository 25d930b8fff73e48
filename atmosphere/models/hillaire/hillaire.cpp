#include "models/hillaire/hillaire.h"

#include "module/requirements.h"

#include "aureole_atmosphere_shaders.h"

#include <algorithm>
#include <array>

namespace aureole {
namespace detail {
namespace {

constexpr std::array<std::string_view, 2> air_passes{"transmittance", "multi_scatter"};
constexpr std::array<std::string_view, 2> view_passes{"sky_view", "aerial_perspective"};

class HillaireModel final : public Model {
public:
    explicit HillaireModel(const models::HillaireSettings& settings) : settings_(settings) { HillaireModel::validate(); }
    [[nodiscard]] std::string_view name() const noexcept override { return "hillaire"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return unused_; }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters&) const override;
    void validate() const override { models::validate(settings_); }
    [[nodiscard]] bool by_tables() const noexcept override { return settings_.fast_sky && settings_.fast_aerial_perspective; }
    void require(const rhi::Device& device) const override;
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared, const AtmosphereParameters&) const override {
        return std::make_unique<HillaireAir>(shared, settings_);
    }

private:
    models::HillaireSettings settings_;
    QualitySettings unused_;
};

std::vector<ModelTable> HillaireModel::tables_for(const AtmosphereParameters&) const {
    const models::HillaireSettings& s = settings_;
    const auto steps = [](int count, const char* of) { return std::to_string(count) + " steps " + of; };
    std::vector<ModelTable> tables{
        {"transmittance table", s.transmittance, s.table_format, steps(s.transmittance_steps, "a ray")},
        {"multi-scatter table", s.multi_scatter, s.table_format,
         std::to_string(hillaire_rays_per_node) + " rays of " + std::to_string(s.multi_scatter_steps) + " steps"}};
    tables.push_back({"sky-view table", s.sky_view, s.table_format,
                      steps(s.sky_view_steps, s.fast_sky ? "a ray" : "a ray; for light alone, pixels march")});
    if (s.fast_aerial_perspective) tables.push_back({"froxels", s.aerial_perspective, s.froxel_format, "two steps a slice"});
    return tables;
}

void HillaireModel::require(const rhi::Device& device) const {
    const rhi::Capabilities& capabilities = device.capabilities();
    require_table(device, settings_.table_format, rhi::Dimension::d2);
    require_table(device, settings_.froxel_format, rhi::Dimension::d3);
    const rhi::Extent &t = settings_.transmittance, &f = settings_.aerial_perspective;
    require_size("device.max_texture_2d", capabilities.max_texture_2d,
                 std::max({t.width, t.height, hillaire_rays_extent(settings_).height, settings_.sky_view.width}));
    require_size("device.max_texture_3d", capabilities.max_texture_3d, std::max({f.width, f.height, f.depth}));
}

bool has_sky_view(const models::HillaireSettings& settings, const ViewSettings& view) {
    return settings.fast_sky || view.light;
}
bool has_froxels(const models::HillaireSettings& settings, const ViewSettings& view) {
    return settings.fast_aerial_perspective && view.aerial_perspective;
}

}  // namespace

HillaireAir::HillaireAir(AirResources& shared, const models::HillaireSettings& settings)
    : settings_(settings),
      transmittance_(shared, {&shaders::hillaire_transmittance, settings.transmittance, settings.table_format,
                              settings.transmittance_steps}),
      multi_scatter_(shared, transmittance_.table(), settings) {}

std::span<const std::string_view> HillaireAir::passes() const noexcept { return air_passes; }

void HillaireAir::complete(const AtmosphereParameters&, AtmosphereBlock& block) const noexcept {
    block.tables.z = 0;  // the published axis of altitude, not stretched for low air
}

void HillaireAir::invalidate() noexcept {
    transmittance_.invalidate();
    multi_scatter_.invalidate();
    stale_ = true;
}

bool HillaireAir::record(rhi::CommandList& commands, const AtmosphereBlock&, std::span<PassReport> reports,
                         TimestampSlots timestamps) {
    if (!stale_) return false;
    transmittance_.record(commands, reports[0], timestamps, 0);
    multi_scatter_.record(commands, reports[1], timestamps, 1);
    stale_ = false;
    return true;
}

std::unique_ptr<ModelView> HillaireAir::make_view(ViewResources& shared, const ViewSettings& settings) {
    const ViewTableSizes sizes{has_sky_view(settings_, settings) ? settings_.sky_view.height : 0,
                               has_froxels(settings_, settings) ? settings_.aerial_perspective.height : 0};
    require_view(shared.objects.device(), "hillaire", sizes, shared.suns, 1);
    // All phase functions are applied in the tables (5: none is kept apart), whose azimuth axis is sin(azimuth / 2) (7).
    const TableViewResources tables{shared,
                                    transmittance_.table(),
                                    multi_scatter_.table(),
                                    1,
                                    {{5, 0}, {7, 1}, {28, settings_.grey_transmittance && !shared.air.summed ? 1U : 0U}}};
    return std::make_unique<HillaireView>(tables, settings_, settings);
}

HillaireView::HillaireView(const TableViewResources& shared, const models::HillaireSettings& settings, const ViewSettings& view)
    : shared_(shared),
      froxels_(shared_, {&shaders::hillaire_aerial_perspective, settings.aerial_perspective, settings.froxel_format, 0},
               FroxelWork::froxel, has_froxels(settings, view)) {
    if (has_sky_view(settings, view))
        sky_view_.emplace(shared_, TableKernel{&shaders::hillaire_sky_view, settings.sky_view, settings.table_format,
                                               settings.sky_view_steps});
    kernels_ = choose_kernels(settings, view);
}

ModelKernels HillaireView::choose_kernels(const models::HillaireSettings& settings, const ViewSettings& view) {
    ModelKernels kernels;
    const rhi::Sampler linear = shared_.air.linear;
    // What is marched reads no table; any one that is readable stands in its slot.
    const rhi::Texture sky_view = sky_view_ ? sky_view_->table().handle : shared_.transmittance.handle;
    kernels.tables = {{2, sky_view, linear, {}},
                      {3, shared_.transmittance.handle, linear, {}},
                      {4, froxels_.table().handle, linear, {}},
                      {11, shared_.multi_scatter.handle, linear, {}}};
    kernels.specialization = shared_.specialization;
    kernels.aerial_perspective = view.aerial_perspective;
    kernels.light = &shaders::light;
    if (settings.fast_sky && (settings.fast_aerial_perspective || !view.aerial_perspective)) {
        kernels.composite = &shaders::composite;
        kernels.composite_raster = &shaders::composite_raster;
        return kernels;
    }
    kernels.composite = &shaders::hillaire_composite;
    kernels.composite_raster = &shaders::hillaire_composite_raster;
    kernels.specialization.insert(kernels.specialization.end(), {{8, static_cast<std::uint32_t>(settings.march_steps)},
                                                                 {26, settings.fast_sky ? 1U : 0U},
                                                                 {27, settings.fast_aerial_perspective ? 1U : 0U}});
    return kernels;
}

std::span<const std::string_view> HillaireView::passes() const noexcept { return view_passes; }

void HillaireView::update(const ViewBlock& before, const ViewBlock& fresh) noexcept {
    sky_stale_ |= !(SkyViewKey::of(fresh) == SkyViewKey::of(before));
    froxels_stale_ |= !same_froxels(before, fresh);
}

void HillaireView::invalidate() noexcept {
    if (sky_view_) sky_view_->invalidate();
    froxels_.invalidate();
    restart();
    recorded_ = false;
}

void HillaireView::record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) {
    froxels_.prepare(commands);
    if (sky_stale_ && sky_view_) sky_view_->record(commands, reports[0], timestamps, 0);
    if (froxels_stale_ && froxels_.enabled()) froxels_.record(commands, reports[1], timestamps, 1);
    sky_stale_ = froxels_stale_ = false;
    recorded_ = true;
}

rhi::Texture HillaireView::sky_view_table() const noexcept { return sky_view_ ? sky_view_->table().handle : rhi::Texture{}; }
rhi::Texture HillaireView::aerial_perspective_table() const noexcept {
    return kernels_.aerial_perspective && !froxels_.enabled() ? rhi::Texture{} : froxels_.table().handle;
}

std::vector<LightTexture> HillaireView::light_textures() {
    return sky_and_froxels(shared_, sky_view_ ? &*sky_view_ : nullptr, froxels_);
}

}  // namespace detail

namespace models {

ModelPtr hillaire(const HillaireSettings& settings) { return std::make_shared<detail::HillaireModel>(settings); }

}  // namespace models
}  // namespace aureole
