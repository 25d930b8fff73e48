// Recorder of a model in N wavelengths: the model's own recorders, one a triplet, and the sums of their tables; of a model that
// computes light for each pixel, what its composite and light are run with, once a triplet.
#pragma once

#include "models/spectral/sum.h"
#include "module/air.h"

#include <aureole/models/spectral.h>

namespace aureole::detail {

/// Adds up to what one record() of a model's passes does, for several models.
struct InnerReports {
    std::vector<PassReport> reports;  ///< Of all, one model after another.
    std::size_t each = 0;
    void make(std::span<const std::string_view> names, std::size_t models);
    /// The first of these names, or two if there are sums; none if the models have no passes.
    [[nodiscard]] std::span<const std::string_view> named(std::span<const std::string_view> names, bool sums) const noexcept {
        return names.first(each == 0 ? 0 : (sums ? 2 : 1));
    }
    [[nodiscard]] std::span<PassReport> of(std::size_t model) { return std::span(reports).subspan(model * each, each); }
    void add_to(PassReport& report) const noexcept;
};

class SpectralAir final : public ModelAir {
public:
    SpectralAir(AirResources& shared, const AtmosphereParameters& parameters, const ModelPtr& inner,
                const models::SpectralSettings& settings);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    void complete(const AtmosphereParameters& parameters, AtmosphereBlock& block) const noexcept override;
    [[nodiscard]] bool fits(const AtmosphereParameters& parameters) const override;
    void restart(const AtmosphereParameters& parameters, const AtmosphereBlock& before, const AtmosphereBlock& fresh) override;
    void invalidate() noexcept override;
    bool record(rhi::CommandList& commands, const AtmosphereBlock& block, std::span<PassReport> reports,
                TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override;
    [[nodiscard]] bool due() const noexcept override;
    [[nodiscard]] double progress() const noexcept override;
    /// As of every wavelength's: they have the same structure and go in step. The block here is shown with their tables.
    [[nodiscard]] NewAir new_air() const noexcept override { return airs_.front()->model->new_air(); }
    void spread(int passes_per_frame, bool first_too) override;
    [[nodiscard]] std::uint64_t more_texture_bytes() const noexcept override;
    [[nodiscard]] std::unique_ptr<ModelView> make_view(ViewResources& shared, const ViewSettings& settings) override;
    [[nodiscard]] rhi::Texture transmittance_table() const noexcept override;

    [[nodiscard]] std::span<const std::unique_ptr<AirTables>> airs() const noexcept { return airs_; }
    [[nodiscard]] TrackedBuffer& weights() noexcept { return weights_buffer_; }
    /// The sum that stands for a table of the first triplet; itself where there is none.
    [[nodiscard]] rhi::Texture shown(rhi::Texture table) const noexcept;
    /// False for one triplet that is red, green and blue already.
    [[nodiscard]] bool sums() const noexcept { return sums_needed_; }
    [[nodiscard]] bool by_tables() const noexcept { return inner_->by_tables(); }
    /// For ViewResources of kernels that compute light at three wavelengths; null where there are no sums.
    [[nodiscard]] rhi::Buffer triplet(std::size_t k) const noexcept {
        return triplet_buffers_.empty() ? rhi::Buffer{} : triplet_buffers_[k].handle;
    }

private:
    /// The air of one triplet, on the axes of the atmosphere's tables.
    struct Triplet {
        AtmosphereParameters parameters;
        PackedAtmosphere packed;
    };
    [[nodiscard]] std::vector<Triplet> at_triplets(const AtmosphereParameters& rgb) const;
    /// Solutions that are spread over frames are ready in the same frame, so that what is added up is always of one air.
    void finish_together(std::span<const Triplet> fresh);
    void record_weights(rhi::CommandList& commands);

    ModelPtr inner_;
    models::SpectralSettings settings_;
    std::vector<spectrum::Triplet> triplets_;
    SpectralWeights weights_;
    TrackedBuffer weights_buffer_;
    std::vector<TrackedBuffer> triplet_buffers_;
    bool sums_needed_;
    std::vector<std::unique_ptr<AirTables>> airs_;
    std::vector<SpectralSum> sums_;
    InnerReports inner_reports_;
    int passes_per_frame_ = 0;
    bool first_too_ = false;
};

class SpectralView final : public ModelView {
public:
    SpectralView(ViewResources& shared, const ViewSettings& settings, SpectralAir& air);

    [[nodiscard]] std::span<const std::string_view> passes() const noexcept override;
    [[nodiscard]] const ModelKernels& kernels() const noexcept override { return kernels_; }
    void update(const ViewBlock& before, const ViewBlock& fresh) noexcept override;
    void restart() noexcept override;
    void invalidate() noexcept override;
    void record(rhi::CommandList& commands, std::span<PassReport> reports, TimestampSlots timestamps) override;
    [[nodiscard]] bool ready() const noexcept override;
    [[nodiscard]] bool due() const noexcept override;
    [[nodiscard]] rhi::Texture sky_view_table() const noexcept override;
    [[nodiscard]] rhi::Texture aerial_perspective_table() const noexcept override;

private:
    struct Inner {
        ViewResources shared;
        ViewResources
            shadowed;  ///< Of the pass that finds shadows, whose light is computed even where the model's is in tables.
        std::unique_ptr<ModelView> view;
    };
    [[nodiscard]] rhi::Texture shown(rhi::Texture table) const noexcept;

    SpectralAir& air_;
    std::vector<std::unique_ptr<Inner>> inner_;
    std::vector<SpectralSum> sums_;
    ModelKernels kernels_;
    InnerReports inner_reports_;
};

}  // namespace aureole::detail
