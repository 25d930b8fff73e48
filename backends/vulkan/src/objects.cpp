#include "objects.h"

namespace aureole::vulkan {

bool Objects::destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame) {
    const auto doom = [&](auto typed) {
        if (!typed) return true;
        doomed_.reserve(doomed_.size() + 1);
        auto object = registry_of(typed).take(typed);
        if (!object) return false;
        doomed_.emplace_back(last_used_frame, std::move(object));
        return true;
    };
    return std::visit(doom, handle);
}

void Objects::collect(std::uint64_t completed_frame) noexcept {
    std::erase_if(doomed_, [&](const auto& entry) { return entry.first <= completed_frame; });
}

}  // namespace aureole::vulkan
