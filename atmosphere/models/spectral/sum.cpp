#include "models/spectral/sum.h"

#include "aureole_atmosphere_shaders.h"

namespace aureole::detail {
namespace {

constexpr std::uint32_t first_table_slot = 2;

std::vector<rhi::Binding> slots_of(rhi::Texture sum, const TrackedBuffer& weights, rhi::Sampler nearest,
                                   std::span<const rhi::Texture> tables) {
    std::vector<rhi::Binding> slots{{0, {}, {}, weights.handle}, {1, sum, {}, {}}};
    for (std::size_t k = 0; k < max_triplets; ++k)  // the first stands in for those that are not read
        slots.push_back({first_table_slot + static_cast<std::uint32_t>(k), tables[k < tables.size() ? k : 0], nearest, {}});
    return slots;
}

}  // namespace

SpectralSum::SpectralSum(Objects& objects, rhi::Sampler nearest, const TrackedBuffer& weights, const LightTexture& kind,
                         std::span<const rhi::Texture> tables)
    : shader_(kind.table->dimension == rhi::Dimension::d3 ? &shaders::spectral_sum_3d : &shaders::spectral_sum_2d),
      sum_(objects.texture({"spectral sum", kind.table->dimension, kind.table->format, kind.table->extent,
                            rhi::Usage::sampled | rhi::Usage::storage | rhi::Usage::copy_source})),
      first_(tables.front()) {
    const std::vector<rhi::Binding> slots = slots_of(sum_.handle, weights, nearest, tables);
    const auto pipeline = [&](bool depth) {
        Specialize values;
        values.set(8, static_cast<int>(tables.size())).set(51, depth);
        return objects.compute(*shader_, values.values());
    };
    const std::uint32_t rows = sum_.extent.height / kind.layers;
    const std::uint32_t depth_begin =
        kind.depth_layer < 0 ? sum_.extent.height : static_cast<std::uint32_t>(kind.depth_layer) * rows;
    const std::uint32_t depth_end = kind.depth_layer < 0 ? sum_.extent.height : depth_begin + rows;
    rhi::Pipeline radiance;
    const auto add = [&](bool depth, std::uint32_t begin, std::uint32_t end) {
        if (begin == end) return;
        if (!depth && !radiance) radiance = pipeline(false);
        const rhi::Pipeline used = depth ? pipeline(true) : radiance;
        parts_.push_back({used, objects.bindings("spectral sum", used, slots), begin, end});
    };
    add(false, 0, depth_begin);
    add(true, depth_begin, depth_end);
    add(false, depth_end, sum_.extent.height);
}

void SpectralSum::record(rhi::CommandList& commands, PassScope& scope, PassReport& report) {
    for (const Part& part : parts_) {
        move(commands, {{&sum_, rhi::State::storage_write}});
        const glm::vec4 range(static_cast<float>(part.begin), static_cast<float>(part.end), 0, 0);
        const rhi::Extent texels{sum_.extent.width, part.end - part.begin, sum_.extent.depth};
        scope.dispatch(*shader_, part.pipeline, part.bindings, texels, std::as_bytes(std::span(&range, 1)));
    }
    move(commands, {{&sum_, rhi::State::sampled}});
    report.bytes_written += sum_.bytes;
}

}  // namespace aureole::detail
