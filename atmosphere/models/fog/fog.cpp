// Fog keeps no tables: only the nodes of its one quadrature.
#include "common/check.h"
#include "common/check_table.h"
#include "models/model.h"
#include "quadrature/gauss_legendre.h"

#include <aureole/models/fog.h>

#include "aureole_atmosphere_shaders.h"

#include <bit>

namespace aureole {
namespace detail {
namespace {

using models::FogSettings;

class FogView final : public ModelView {
public:
    FogView(ModelKernels kernels) : kernels_(std::move(kernels)) {}
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }

private:
    ModelKernels kernels_;
};

class FogAir final : public ModelAir {
public:
    FogAir(AirResources& shared, const FogSettings& settings)
        : settings_(settings),
          rule_(quadrature_block(settings.transmittance_nodes)),
          quadrature_(shared.objects.constants("fog quadrature", sizeof rule_)) {}

    void invalidate() noexcept override { forget(quadrature_); }
    bool record(rhi::CommandList& commands, const AtmosphereBlock&, std::span<PassReport>, TimestampSlots) override {
        if (ready()) return false;
        update_block(commands, quadrature_, rule_);
        return true;
    }
    [[nodiscard]] bool ready() const noexcept override { return quadrature_.state != rhi::State::undefined; }
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources&, const ViewSettings& settings) override {
        ModelKernels kernels;
        kernels.composite = &shaders::fog_composite;
        kernels.composite_raster = &shaders::fog_composite_raster;
        kernels.light = &shaders::fog_light;
        kernels.tables = {{2, {}, {}, quadrature_.handle}};
        kernels.specialization = specialization();
        kernels.aerial_perspective = settings.aerial_perspective;
        return std::make_unique<FogView>(std::move(kernels));
    }

private:
    [[nodiscard]] std::vector<rhi::Specialization> specialization() const {
        const auto real = [](std::uint32_t id, double value) {
            return rhi::Specialization{id, std::bit_cast<std::uint32_t>(static_cast<float>(value))};
        };
        return {{30, static_cast<std::uint32_t>(settings_.transmittance_nodes)},
                {31, settings_.mode == FogSettings::Mode::one_colour ? 1U : 0U},
                {32, settings_.sky == FogSettings::Sky::infinity ? 1U : 0U},
                real(33, settings_.density_per_m * 1e3),
                real(34, settings_.colour.r),
                real(35, settings_.colour.g),
                real(36, settings_.colour.b)};
    }

    FogSettings settings_;
    QuadratureBlock rule_;
    TrackedBuffer quadrature_;
};

class FogModel final : public Model {
public:
    explicit FogModel(const FogSettings& settings) : settings_(settings) { FogModel::validate(); }
    [[nodiscard]] std::string_view name() const noexcept override { return "fog"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return no_tables_; }
    void validate() const override { models::validate(settings_); }
    void require(const rhi::Device&) const override {}
    [[nodiscard]] bool has_shadows() const noexcept override { return false; }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared, const AtmosphereParameters&) const override {
        return std::make_unique<FogAir>(shared, settings_);
    }

private:
    FogSettings settings_;
    QualitySettings no_tables_;
};

}  // namespace
}  // namespace detail

namespace models {

void validate(const FogSettings& settings) {
    detail::check_enum("fog.mode", settings.mode, FogSettings::Mode::in_scatter, "one_colour or in_scatter");
    detail::check_enum("fog.sky", settings.sky, FogSettings::Sky::infinity, "top_of_air or infinity");
    detail::check_rgb("fog.colour", settings.colour, 0, 1e6);
    detail::check("fog.density_per_m", settings.density_per_m, 0, 1e3);
    detail::check("fog.transmittance_nodes", settings.transmittance_nodes, 2, 16);
}

FogSettings FogSettings::by_name(std::string_view quality) {
    FogSettings settings;
    if (quality == "default") return settings;
    if (quality == "low") {
        settings.mode = Mode::one_colour;
    } else if (quality == "high" || quality == "converged") {
        settings.transmittance_nodes = 16;
    } else {
        detail::reject_quality(quality);
    }
    return settings;
}

ModelPtr fog(const FogSettings& settings) { return std::make_shared<detail::FogModel>(settings); }

}  // namespace models
}  // namespace aureole
