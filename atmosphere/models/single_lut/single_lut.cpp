// Single scattering (models/single) with the transmittance table in the place of the nested march.
#include "common/check.h"
#include "common/check_table.h"
#include "models/single/single.h"
#include "module/requirements.h"

#include <aureole/models/single_lut.h>

#include "aureole_atmosphere_shaders.h"

#include <algorithm>

namespace aureole {
namespace detail {
namespace {

using models::SingleLutSettings;

/// Settings of the transmittance pass; the rest has no effect.
QualitySettings table_quality(const SingleLutSettings& settings) {
    QualitySettings quality;
    quality.transmittance = settings.table;
    quality.transmittance_nodes = settings.table_nodes;
    quality.table_format = settings.table_format;
    return quality;
}

class SingleLutModel final : public Model {
public:
    explicit SingleLutModel(const SingleLutSettings& settings) : settings_(settings), quality_(table_quality(settings)) {
        SingleLutModel::validate();
    }
    [[nodiscard]] std::string_view name() const noexcept override { return "single-lut"; }
    [[nodiscard]] const QualitySettings& quality() const noexcept override { return quality_; }
    [[nodiscard]] std::vector<ModelTable> tables_for(const AtmosphereParameters&) const override {
        std::vector<ModelTable> tables{{"transmittance table", settings_.table, settings_.table_format,
                                        std::to_string(settings_.table_nodes) + " nodes a ray"}};
        if (settings_.dome.used()) tables.push_back(dome_table(settings_.dome, settings_.view_steps));
        return tables;
    }
    void validate() const override { models::validate(settings_); }
    void require(const rhi::Device& device) const override {
        require_table(device, settings_.table_format, rhi::Dimension::d2);
        require_size("device.max_texture_2d", device.capabilities().max_texture_2d,
                     std::max(settings_.table.width, settings_.table.height));
        require_dome(device, settings_.dome);
    }
    [[nodiscard]] std::unique_ptr<ModelAir> make_air(AirResources& shared, const AtmosphereParameters&) const override {
        models::SingleSettings march;
        march.steps = settings_.steps;
        march.view_steps = march.light_steps = settings_.view_steps;
        march.dome = settings_.dome;
        return std::make_unique<SingleAir>(shared,
                                           SingleSetup{march,
                                                       {&shaders::single_lut_composite, &shaders::single_lut_composite_raster,
                                                        &shaders::single_lut_light, &shaders::single_lut_dome},
                                                       true,
                                                       "single_lut"});
    }

private:
    SingleLutSettings settings_;
    QualitySettings quality_;
};

}  // namespace
}  // namespace detail

namespace models {

void validate(const SingleLutSettings& settings) {
    detail::check_steps_kind("single_lut.steps", settings.steps);
    detail::check_steps("single_lut.view_steps", settings.steps, settings.view_steps);
    detail::check("single_lut.table.width", settings.table.width, 2, 4096);
    detail::check("single_lut.table.height", settings.table.height, 2, 4096);
    detail::check("single_lut.table.depth", settings.table.depth, 1, 1);
    detail::check("single_lut.table_nodes", settings.table_nodes, 2, detail::max_nodes);
    detail::check_table_format("single_lut.table_format", settings.table_format);
    detail::check_dome("single_lut.dome", settings.dome);
}

SingleLutSettings SingleLutSettings::by_name(std::string_view quality) {
    SingleLutSettings settings;
    if (quality == "default") return settings;
    if (quality == "low") {
        settings.view_steps = 6;
        settings.table = {64, 16, 1};
        settings.dome.size = {24, 64, 1};
    } else if (quality == "high") {
        settings.view_steps = 12;
        settings.table = {256, 64, 1};
    } else if (quality == "converged") {
        settings.view_steps = settings.table_nodes = 16;
        settings.table = {1024, 256, 1};
    } else {
        detail::reject_quality(quality);
    }
    return settings;
}

ModelPtr single_lut(const SingleLutSettings& settings) { return std::make_shared<detail::SingleLutModel>(settings); }

}  // namespace models
}  // namespace aureole
