// Objects by handle.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace aureole::cpu {

/// Destroyed objects can no longer be recorded (`alive`), but work recorded before still finds them (`any`) until their
/// frame has been collected.
template <class Handle, class Object>
class Pool {
public:
    void add(Handle handle, std::shared_ptr<Object> object) { entries_.emplace(handle.value, Entry{std::move(object), false}); }

    [[nodiscard]] std::shared_ptr<Object> alive(Handle handle) const {
        const auto found = entries_.find(handle.value);
        return found == entries_.end() || found->second.destroyed ? nullptr : found->second.object;
    }
    [[nodiscard]] Object* any(Handle handle) const {
        const auto found = entries_.find(handle.value);
        return found == entries_.end() ? nullptr : found->second.object.get();
    }

    /// False if the handle is unknown or destroyed already.
    bool destroy(Handle handle, std::uint64_t last_used_frame) {
        const auto found = entries_.find(handle.value);
        if (found == entries_.end() || found->second.destroyed) return false;
        graves_.emplace_back(last_used_frame, handle.value);
        found->second.destroyed = true;
        return true;
    }

    void collect(std::uint64_t completed_frame) {
        std::erase_if(graves_, [&](const auto& grave) {
            if (grave.first > completed_frame) return false;
            entries_.erase(grave.second);
            return true;
        });
    }

private:
    struct Entry {
        std::shared_ptr<Object> object;
        bool destroyed = false;
    };
    std::unordered_map<std::uint64_t, Entry> entries_;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> graves_;  // last frame, handle
};

}  // namespace aureole::cpu
