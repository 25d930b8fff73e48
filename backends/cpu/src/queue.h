// Runs recorded lists in the calling thread (and the device's workers).
#pragma once

#include "command_list.h"
#include "device.h"
#include "executor.h"

namespace aureole::cpu {

class CpuQueue final : public rhi::Queue {
public:
    explicit CpuQueue(CpuRhiDevice& device) : device_(device), list_(device), executor_(device) {}

    [[nodiscard]] rhi::CommandList& begin() override;
    std::uint64_t submit() override;
    void wait() override;

private:
    CpuRhiDevice& device_;
    CpuCommandList list_;
    Executor executor_;
    bool recording_ = false;
    std::uint64_t frame_ = 0;  // the last one submitted
};

}  // namespace aureole::cpu
