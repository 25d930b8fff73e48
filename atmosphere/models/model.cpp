#include "models/model.h"

#include <algorithm>

namespace aureole::detail {

Specialize ViewResources::specialize() const {
    Specialize values(air.air);
    values.set(6, static_cast<int>(suns)).set(9, air.quality.angular_order).set(24, static_cast<int>(projection));
    if (triplet) values.set(52, true);  // IN_TRIPLETS of common/triplet.glsl
    return values;
}

std::vector<TripletKernels> runs_of(ViewResources& shared, const ModelKernels& kernels) {
    return kernels.triplets.empty() ? std::vector{TripletKernels{&shared, &kernels}} : kernels.triplets;
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
