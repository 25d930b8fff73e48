// Recorder of single scattering, with or without a table of optical depth: models single and single-lut.
#pragma once

#include "models/model.h"
#include "models/single/dome.h"
#include "transmittance/transmittance.h"

#include <aureole/models/single.h>

#include <optional>

namespace aureole::detail {

/// The kernels of one of the two models.
struct SingleKernels {
    const rhi::Shader *composite, *composite_raster, *light, *dome;
};

/// What both are told. `table`: optical depth comes from a table of AirResources::quality; light_steps are not used then.
struct SingleSetup {
    models::SingleSettings settings;
    SingleKernels kernels;
    bool table;
    std::string_view prefix;  ///< Of the settings' names in errors.
};

class SingleAir final : public ModelAir {
public:
    SingleAir(AirResources& shared, const SingleSetup& setup);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) override;
    void invalidate() noexcept override;
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] std::vector<LightTexture> light_textures() override;
    [[nodiscard]] bool ready() const noexcept override { return view_nodes_.state != rhi::State::undefined; }
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept override;

private:
    AirResources& shared_;
    SingleSetup setup_;
    QuadratureBlock view_rule_, light_rule_;
    TrackedBuffer view_nodes_, light_nodes_;
    std::optional<TransmittancePass> table_;
    bool table_stale_ = true;
};

/// Checks shared by both models' settings; `field` begins with the model's name and a dot.
void check_steps(const std::string& field, models::Steps steps, int count);
void check_steps_kind(const std::string& field, models::Steps steps);
void check_dome(const std::string& field, const models::Dome& dome);
/// Throws Error(unsupported) where the device cannot hold a dome.
void require_dome(const rhi::Device& device, const models::Dome& dome);

}  // namespace aureole::detail
