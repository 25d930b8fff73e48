// The recorder of the model: which tables are due, and the set that views read while another is being made.
#pragma once

#include "models/bruneton/solution.h"
#include "models/model.h"
#include "transmittance/transmittance.h"

#include <optional>

namespace aureole::detail {

class BrunetonAir final : public ModelAir {
public:
    BrunetonAir(AirResources& shared, const AtmosphereParameters& parameters, const models::BrunetonSettings& settings);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept override;
    void restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) override;
    [[nodiscard]] bool fits(const AtmosphereParameters& parameters) const override;
    void invalidate() noexcept override;
    [[nodiscard]] NewAir new_air() const noexcept override;
    [[nodiscard]] AirResources* apart() noexcept override { return back_ ? &*back_->shared : nullptr; }
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override { return shown_; }
    [[nodiscard]] bool due() const noexcept override { return stale_ || working_; }
    [[nodiscard]] std::vector<LightTexture> light_textures() override {
        return {{&transmittance_.table(), 1, 0}, {&front_.scattering}, {&front_.irradiance}};
    }
    [[nodiscard]] double progress() const noexcept override;
    void spread(int passes_per_frame, bool first_too) override;
    [[nodiscard]] std::uint64_t more_texture_bytes() const noexcept override;
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept override { return transmittance_.table().handle; }

    [[nodiscard]] TrackedTexture& scattering() noexcept { return front_.scattering; }
    [[nodiscard]] TrackedTexture& irradiance() noexcept { return front_.irradiance; }

private:
    /// A second set of tables, in which a solution grows over frames, with the air that it is for.
    struct Back {
        std::unique_ptr<Objects> objects;
        TrackedBuffer block;
        TrackedTexture profiles, phases;
        std::optional<AirResources> shared;
        std::optional<TransmittancePass> transmittance;
        BrunetonTables tables;
        BrunetonSolution::Bindings bindings;
    };
    [[nodiscard]] std::unique_ptr<Back> make_back() const;
    [[nodiscard]] int budget() const noexcept;
    [[nodiscard]] bool in_parts() const noexcept;
    void solve_at_once(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps);
    /// True if the tables in use have changed.
    bool solve_a_part(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps);
    void show(rhi::CommandList& commands);

    AirResources& shared_;
    models::BrunetonSettings settings_;
    bool combined_;
    TransmittancePass transmittance_;
    BrunetonSolution solution_;
    BrunetonTables front_;
    BrunetonSolution::Bindings front_bindings_;
    std::unique_ptr<Back> back_;
    int passes_per_frame_ = 0;
    bool first_too_ = false;
    bool stale_ = true;     // a solution for the air as it is has not been started
    bool working_ = false;  // one has been, in the back tables, for this air or for one before
    bool shown_ = false;    // the front tables hold a solution
    bool fits_ = false;     // of a planet of the same radii, by which views place their rays
};

class BrunetonView final : public ModelView {
public:
    BrunetonView(ViewResources& shared, const ViewSettings& settings, const models::BrunetonSettings& model,
                 const BrunetonTables& tables, const std::vector<rhi::Specialization>& look_up);
    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override;
    void restart() noexcept override { stale_ = true; }
    void invalidate() noexcept override;
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override { return table_.state != rhi::State::undefined; }
    [[nodiscard]] bool due() const noexcept override { return stale_ && (!from_space_ || !ready()); }
    [[nodiscard]] std::vector<LightTexture> light_textures() override { return {{&table_}, {&depth_, 1, 0}}; }

private:
    TrackedTexture table_, depth_;
    rhi::Extent invocations_;
    rhi::Pipeline pipeline_;
    rhi::BindingSet bindings_;
    ModelKernels kernels_;
    bool stale_ = true;
    bool from_space_ = false;  // then it is not read
};

}  // namespace aureole::detail
