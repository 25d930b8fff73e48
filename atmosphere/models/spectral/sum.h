// Recorder of the pass that adds up tables of several wavelengths.
#pragma once

#include "models/model.h"

#include <array>

namespace aureole::detail {

inline constexpr std::size_t max_triplets = 14;

/// How wavelengths add up: SpectralBlock of spectral_sum.glsl.
struct SpectralWeights {
    std::array<glm::vec4, 3 * max_triplets> to_rgb{};
    std::size_t triplets = 0;
};

/// One table of the sum, with the same size, layers and format as the tables that it is the sum of.
class SpectralSum {
public:
    /// `kind`: of each of `tables`, one a triplet. `weights`: the block on the device.
    SpectralSum(Objects& objects, rhi::Sampler nearest, const TrackedBuffer& weights, const LightTexture& kind,
                std::span<const rhi::Texture> tables);

    /// Reads the tables in State::sampled, and leaves the sum there. `weights` has been written.
    void record(rhi::CommandList& commands, PassScope& scope, PassReport& report);
    void invalidate() noexcept { forget(sum_); }
    [[nodiscard]] bool ready() const noexcept { return sum_.state != rhi::State::undefined; }
    [[nodiscard]] rhi::Texture first_table() const noexcept { return first_; }
    [[nodiscard]] rhi::Texture table() const noexcept { return sum_.handle; }

private:
    /// Layers of one kind.
    struct Part {
        rhi::Pipeline pipeline;
        rhi::BindingSet bindings;
        std::uint32_t begin, end;  ///< Rows.
    };

    const rhi::Shader* shader_;
    TrackedTexture sum_;
    rhi::Texture first_;
    std::vector<Part> parts_;
};

}  // namespace aureole::detail
