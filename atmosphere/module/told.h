// What recording functions tell the log, which a host calls each frame: once, until it is so no longer.
#pragma once

#include <aureole/atmosphere.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace aureole::detail {

/// One condition that lasts for some frames.
class Told {
public:
    /// True where `holds` did not hold at the call before.
    bool begins(bool holds) noexcept {
        const bool begun = holds && !held_;
        held_ = holds;
        return begun;
    }

private:
    bool held_ = false;
};

/// Targets that nobody prepared. Allocates nothing: beyond the latest `count`, they are told again.
class ToldTargets {
public:
    /// True where `targets` have not been told yet.
    bool begins(const CompositeTargets& targets) noexcept {
        if (std::ranges::find(told_, std::optional(targets)) != told_.end()) return false;
        told_[next_] = targets;
        next_ = (next_ + 1) % count;
        return true;
    }
    void end(const CompositeTargets& targets) noexcept { std::ranges::replace(told_, std::optional(targets), std::nullopt); }

private:
    static constexpr std::size_t count = 16;
    std::array<std::optional<CompositeTargets>, count> told_{};
    std::size_t next_ = 0;
};

}  // namespace aureole::detail
