#include "models/model.h"

#include <algorithm>
#include <bit>

namespace aureole::detail {

Specialize ViewResources::specialize() const {
    const bool published = air.quality.sampling == Sampling::published_2020;
    Specialize values(air.air);
    values.set(6, static_cast<int>(suns))
        .set(7, published)
        .set(9, air.quality.angular_order)
        .set(24, static_cast<int>(projection));
    // The published tables hold all phase functions applied.
    if (published) values.set(5, 0);
    return values;
}

std::uint32_t ViewResources::layers_per_sun() const {
    if (air.quality.sampling == Sampling::published_2020) return 1;
    return 1 + static_cast<std::uint32_t>(std::popcount(air.air.sharp_phases));
}

std::vector<rhi::Binding> bindings_of(const rhi::Shader& shader, std::span<const rhi::Binding> offered) {
    std::vector<rhi::Binding> result;
    for (const rhi::Binding& binding : offered) {
        const auto wants = [&](const rhi::SlotDesc& slot) { return slot.slot == binding.slot; };
        if (std::any_of(shader.slots.begin(), shader.slots.end(), wants)) result.push_back(binding);
    }
    std::sort(result.begin(), result.end(), [](const rhi::Binding& a, const rhi::Binding& b) { return a.slot < b.slot; });
    return result;
}

}  // namespace aureole::detail
