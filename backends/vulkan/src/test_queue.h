// rhi::Queue on a host that lends its command buffer for each list and submits it to its own queue.
#pragma once

#include "test_host.h"

namespace aureole::vulkan::test {

class HostQueue final : public rhi::Queue {
public:
    HostQueue(Host& host, BorrowedVulkanDevice& guest) : host_(host), guest_(guest) {}
    [[nodiscard]] rhi::CommandList& begin() override { return guest_.begin_recording(host_.commands()); }
    [[nodiscard]] std::uint64_t submit() override {
        guest_.end_recording();
        if (!held_) host_.submit_and_wait();
        return ++frame_;
    }
    void wait() override {
        if (!held_) guest_.device().collect(frame_);
    }

    /// While held, lists go one after the other into the same command buffer, and the host's own commands between them.
    void hold() noexcept { held_ = true; }
    void release() {
        held_ = false;
        host_.submit_and_wait();
        wait();
    }

private:
    Host& host_;
    BorrowedVulkanDevice& guest_;
    std::uint64_t frame_ = 0;
    bool held_ = false;
};

}  // namespace aureole::vulkan::test
