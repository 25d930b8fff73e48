// The path tracer's recorder. Of the air it keeps how tabulated profiles bend, if transmittances are tracked; of a view, the
// film, if one is asked for.
#pragma once

#include "models/model.h"

#include <aureole/models/reference.h>

namespace aureole::detail {

class ReferenceAir final : public ModelAir {
public:
    ReferenceAir(AirResources& shared, const models::ReferenceSettings& settings);
    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) override;
    void invalidate() noexcept override { forget(bends_); }
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override { return !has_bends_ || bends_.state != rhi::State::undefined; }
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;

private:
    models::ReferenceSettings settings_;
    bool has_bends_;
    bool stale_ = true;
    TrackedTexture bends_;  ///< bends.glsl
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
};

class ReferenceView final : public ModelView {
public:
    /// `bends`: of tabulated profiles, or whatever stands in where there is no need of them.
    ReferenceView(ViewResources& shared, const ViewSettings& view, const models::ReferenceSettings& settings,
                  rhi::Texture bends);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override;
    void restart() noexcept override;
    void invalidate() noexcept override;
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override;
    [[nodiscard]] bool due() const noexcept override;
    [[nodiscard]] rhi::Texture film_table() const noexcept override { return film_.handle; }

private:
    [[nodiscard]] bool has_film() const noexcept { return settings_.film_width > 0; }
    [[nodiscard]] bool film_due() const noexcept;
    void make_film(ViewResources& shared);
    void make_light(ViewResources& shared);
    [[nodiscard]] rhi::Binding bends_binding(const ViewResources& shared) const { return {4, bends_, shared.air.nearest, {}}; }
    void restart_film() noexcept;
    void record_film(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps);
    void record_light(rhi::CommandList& commands, PassReport& report, TimestampSlots timestamps, std::uint32_t index);

    models::ReferenceSettings settings_;
    rhi::Texture bends_;
    QuadratureBlock rule_;
    TrackedBuffer quadrature_;
    /// Kernels do not write what they read: a frame's sums are made in the second and copied to the first.
    TrackedTexture film_, next_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet start_, go_on_;  ///< Of a new film, which has nothing to read, and of one that has.
    int paths_ = 0;                  ///< In each texel of the film.
    bool started_ = false;           ///< The film holds what this camera sees of this air.

    bool has_light_;
    bool light_stale_ = true;
    QuadratureBlock zenith_rule_;
    TrackedBuffer zeniths_;
    TrackedTexture light_;  ///< The directions of the light's integral (light_paths.glsl).
    rhi::Pipeline light_pipeline_;
    rhi::BindingSet light_bindings_;

    ModelKernels kernels_;
};

}  // namespace aureole::detail
