#include "models/model.h"

#include <algorithm>

namespace aureole::detail {

Specialize ViewResources::specialize() const {
    return Specialize(air.air)
        .set(6, static_cast<int>(suns))
        .set(9, air.quality.angular_order)
        .set(24, static_cast<int>(projection));
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
