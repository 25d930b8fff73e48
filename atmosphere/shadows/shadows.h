// Recorder of the shadows pass: what a host's shadow map takes from the air, in a volume over the screen (shadows.glsl).
#pragma once

#include "models/model.h"

#include <aureole/shadows.h>

#include <optional>

namespace aureole::detail {

/// What the march errs by with slices and samples as by default, of the light of a picture of stripes (shadows.md, tested).
inline constexpr double shadows_march_error = 0.03;

void validate(const ShadowSettings& settings);
/// `settings`, `max_suns`: of the view. Textures are the device's to know.
void validate(const ShadowMap& map, const ShadowSettings& settings, std::uint32_t max_suns, const rhi::Device& device);

/// A map and a camera's position, m from the planet's centre, as the kernels read them; without a texture nothing is in shadow.
[[nodiscard]] ShadowBlock pack_shadows(const ShadowMap& map, std::uint32_t cascades, const glm::dvec3& camera_m);

class ShadowPass {
public:
    /// Makes nothing where shadows are off. `transmittance`: of `shared`'s air; null where the model keeps no such table.
    ShadowPass(ViewResources& shared, const ModelKernels& kernels, const ShadowSettings& settings, rhi::Texture transmittance);

    /// Makes bindings for this map; null: for none. Throws and changes nothing where the device refuses it.
    void use_map(rhi::Texture map);
    void invalidate() noexcept;
    [[nodiscard]] bool enabled() const noexcept { return settings_.cascades > 0; }
    [[nodiscard]] const ShadowSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const TrackedTexture& table() const noexcept { return table_; }
    [[nodiscard]] rhi::Texture map() const noexcept { return map_; }
    [[nodiscard]] rhi::Buffer block() const noexcept { return block_.handle; }
    void record(rhi::CommandList& commands, const ShadowBlock& block, PassReport& report, TimestampSlots timestamps,
                std::uint32_t index);

private:
    ViewResources& shared_;
    ShadowSettings settings_;
    /// In RGB, or of three of N wavelengths.
    struct Run {
        TripletKernels of;
        rhi::Pipeline pipeline;
    };
    [[nodiscard]] TrackedTexture& written_by(std::size_t run) noexcept {
        return run + 1 < runs_.size() ? sums_[run % sums_.size()] : table_;
    }
    [[nodiscard]] Specialize specialization(const TripletKernels& air) const;
    void make_tables(std::uint32_t layers, std::size_t runs);
    [[nodiscard]] rhi::BindingSet bind(Objects& objects, std::size_t run, rhi::Texture map);

    const rhi::Shader* shader_ = nullptr;
    std::vector<Run> runs_;
    std::vector<TrackedTexture> sums_;  ///< What one run leaves to the next.
    TrackedTexture table_;
    TrackedBuffer block_, nodes_;
    QuadratureBlock rule_;
    rhi::Texture map_;
    std::unique_ptr<Objects> map_objects_;
    std::vector<rhi::BindingSet> bindings_;  ///< By run.
};

}  // namespace aureole::detail
