#include "timestamps.h"

#include "result.h"

#include <limits>

namespace aureole::vulkan {

Timestamps::Timestamps(const Context& context) : context_(context) {
    const std::uint32_t bits = context.physical.queue_families[context.queue_family].timestampValidBits;
    if (bits == 0 || !(context.limits().timestampPeriod > 0)) return;
    valid_bits_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    VkQueryPoolCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = max_slots;
    check_result(context_.fn.vkCreateQueryPool(context_.device, &info, nullptr, &pool_), "vkCreateQueryPool", "timestamps");
}

Timestamps::~Timestamps() { context_.fn.vkDestroyQueryPool(context_.device, pool_, nullptr); }

void Timestamps::record(VkCommandBuffer commands, std::uint32_t index) noexcept {
    context_.fn.vkCmdResetQueryPool(commands, pool_, index, 1);
    context_.fn.vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, index);
    recorded_.set(index);
}

void Timestamps::read(std::span<double> out_nanoseconds) const {
    if (out_nanoseconds.size() > slots())
        throw Error(ErrorCode::invalid_argument, "read_timestamps: slots", std::to_string(out_nanoseconds.size()),
                    "at most " + std::to_string(slots()));
    for (std::uint32_t i = 0; i < out_nanoseconds.size(); ++i) {
        out_nanoseconds[i] = std::numeric_limits<double>::quiet_NaN();
        if (!recorded_.test(i)) continue;
        std::uint64_t ticks = 0;
        const VkResult result = context_.fn.vkGetQueryPoolResults(context_.device, pool_, i, 1, sizeof ticks, &ticks,
                                                                  sizeof ticks, VK_QUERY_RESULT_64_BIT);
        check_result(result, "vkGetQueryPoolResults", "timestamps");
        if (result == VK_SUCCESS)
            out_nanoseconds[i] =
                static_cast<double>(ticks & valid_bits_) * static_cast<double>(context_.limits().timestampPeriod);
    }
}

}  // namespace aureole::vulkan
