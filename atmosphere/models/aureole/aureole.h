// Our model's recorder: which of its passes are due. The passes have rooms of their own: transmittance, multi_scatter,
// sky_view, aerial_perspective.
#pragma once

#include "aerial_perspective/aerial_perspective.h"
#include "models/model.h"
#include "multi_scatter/multi_scatter.h"
#include "sky_view/sky_view.h"
#include "transmittance/transmittance.h"

#include <optional>

namespace aureole::detail {

class AureoleAir final : public ModelAir {
public:
    AureoleAir(AirResources& shared, const AtmosphereParameters& parameters);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept override;
    void restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) override;
    void invalidate() noexcept override;
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override;
    [[nodiscard]] bool due() const noexcept override { return transmittance_stale_ || solving(); }
    [[nodiscard]] std::vector<LightTexture> light_textures() override { return {{&transmittance_.table(), 1, 0}}; }
    void spread(int passes_per_frame, bool first_too) override;
    [[nodiscard]] std::uint64_t more_texture_bytes() const noexcept override {
        return multi_scatter_ ? multi_scatter_->copy_bytes() : 0;
    }
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept override { return transmittance_.table().handle; }
    [[nodiscard]] rhi::Texture multi_scatter_table() const noexcept override {
        return multi_scatter_ ? multi_scatter_->table().handle : rhi::Texture{};
    }
    /// None where QualitySettings::multi_scatter_orders is 0.
    [[nodiscard]] std::optional<MultiScatterPass>& multi_scatter() noexcept { return multi_scatter_; }

private:
    [[nodiscard]] bool solving() const noexcept { return multi_scatter_ && !multi_scatter_->finished(); }

    AirResources& shared_;
    TransmittancePass transmittance_;
    std::optional<MultiScatterPass> multi_scatter_;
    int passes_per_frame_ = 0;
    bool transmittance_stale_ = true;
};

class AureoleView final : public ModelView {
public:
    /// `multi_scatter`: null for single scattering alone.
    AureoleView(ViewResources& shared, const ViewSettings& settings, TrackedTexture& transmittance,
                TrackedTexture* multi_scatter);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override;
    void restart() noexcept override { sky_stale_ = froxels_stale_ = true; }
    void invalidate() noexcept override;
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override;
    [[nodiscard]] bool due() const noexcept override { return sky_stale_ || froxels_stale_; }
    [[nodiscard]] std::vector<LightTexture> light_textures() override;
    [[nodiscard]] rhi::Texture sky_view_table() const noexcept override { return sky_view_.table().handle; }
    [[nodiscard]] rhi::Texture aerial_perspective_table() const noexcept override { return froxels_.table().handle; }

    [[nodiscard]] TrackedTexture& sky_view() noexcept { return sky_view_.table(); }
    [[nodiscard]] AerialPerspectivePass& aerial_perspective() noexcept { return froxels_; }

private:
    TableViewResources shared_;
    SkyViewPass sky_view_;
    AerialPerspectivePass froxels_;
    ModelKernels kernels_;
    bool sky_stale_ = true, froxels_stale_ = true;
};

}  // namespace aureole::detail
