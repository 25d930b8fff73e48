// Recorder of the model hillaire: which of its passes are due.
#pragma once

#include "aerial_perspective/aerial_perspective.h"
#include "models/hillaire/psi.h"
#include "models/model.h"
#include "sky_view/sky_view.h"
#include "transmittance/transmittance.h"

#include <optional>

namespace aureole::detail {

class HillaireAir final : public ModelAir {
public:
    HillaireAir(AirResources& shared, const models::HillaireSettings& settings);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept override;
    void restart(const AtmosphereParameters&, const AtmosphereBlock&, const AtmosphereBlock&) override { stale_ = true; }
    void invalidate() noexcept override;
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] bool due() const noexcept override { return stale_; }
    [[nodiscard]] std::vector<LightTexture> light_textures() override { return {{&transmittance_.table(), 1, 0}}; }
    [[nodiscard]] bool ready() const noexcept override { return multi_scatter_.table().state != rhi::State::undefined; }
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept override { return transmittance_.table().handle; }
    [[nodiscard]] rhi::Texture multi_scatter_table() const noexcept override { return multi_scatter_.table().handle; }

private:
    models::HillaireSettings settings_;
    TransmittancePass transmittance_;
    HillaireMultiScatterPass multi_scatter_;
    bool stale_ = true;
};

class HillaireView final : public ModelView {
public:
    HillaireView(const TableViewResources& shared, const models::HillaireSettings& settings, const ViewSettings& view);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override;
    void restart() noexcept override { sky_stale_ = froxels_stale_ = true; }
    void invalidate() noexcept override;
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override { return recorded_; }
    [[nodiscard]] bool due() const noexcept override { return sky_stale_ || froxels_stale_; }
    [[nodiscard]] std::vector<LightTexture> light_textures() override;
    [[nodiscard]] rhi::Texture sky_view_table() const noexcept override;
    [[nodiscard]] rhi::Texture aerial_perspective_table() const noexcept override;

private:
    [[nodiscard]] ModelKernels choose_kernels(const models::HillaireSettings& settings, const ViewSettings& view);

    TableViewResources shared_;
    std::optional<SkyViewPass> sky_view_;  ///< None: neither the composite nor the light asks for it.
    AerialPerspectivePass froxels_;
    ModelKernels kernels_;
    bool sky_stale_ = true, froxels_stale_ = true, recorded_ = false;
};

}  // namespace aureole::detail
