#include "queue.h"

#include "result.h"

#include <limits>

namespace aureole::vulkan {

Queue::Queue(Device& device, VkQueue queue) : device_(device), context_(device.context()), queue_(queue), list_(device) {
    const auto& fn = context_.fn;
    try {
        VkCommandPoolCreateInfo pool = {};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
        pool.queueFamilyIndex = context_.queue_family;
        check_result(fn.vkCreateCommandPool(context_.device, &pool, nullptr, &pool_), "vkCreateCommandPool", "queue");
        VkCommandBufferAllocateInfo commands = {};
        commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        commands.commandPool = pool_;
        commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        commands.commandBufferCount = 1;
        check_result(fn.vkAllocateCommandBuffers(context_.device, &commands, &commands_), "vkAllocateCommandBuffers", "queue");
        VkFenceCreateInfo fence = {};
        fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        check_result(fn.vkCreateFence(context_.device, &fence, nullptr, &fence_), "vkCreateFence", "queue");
    } catch (...) {
        release();
        throw;
    }
}

Queue::~Queue() { release(); }

void Queue::release() noexcept {
    context_.fn.vkDestroyFence(context_.device, fence_, nullptr);
    context_.fn.vkDestroyCommandPool(context_.device, pool_, nullptr);
}

rhi::CommandList& Queue::begin() {
    if (list_.is_recording()) throw Error(ErrorCode::misuse, "Queue::begin: the command list before was not submitted");
    wait_for_fence();
    check_result(context_.fn.vkResetCommandPool(context_.device, pool_, 0), "vkResetCommandPool", "queue");
    VkCommandBufferBeginInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check_result(context_.fn.vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer", "queue");
    list_.begin(commands_, context_.queue_family);
    return list_;
}

std::uint64_t Queue::submit() {
    if (!list_.is_recording()) throw Error(ErrorCode::misuse, "Queue::submit: nothing was begun");
    list_.end();
    check_result(context_.fn.vkEndCommandBuffer(commands_), "vkEndCommandBuffer", "queue");
    VkSubmitInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    check_result(context_.fn.vkQueueSubmit(queue_, 1, &info, fence_), "vkQueueSubmit", "queue");
    in_flight_ = true;
    return ++submitted_;
}

void Queue::wait() {
    wait_for_fence();
    device_.collect(submitted_);
}

void Queue::wait_for_fence() {
    if (!in_flight_) return;
    const auto& fn = context_.fn;
    check_result(fn.vkWaitForFences(context_.device, 1, &fence_, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
                 "vkWaitForFences", "queue");
    check_result(fn.vkResetFences(context_.device, 1, &fence_), "vkResetFences", "queue");
    in_flight_ = false;  // not before: nothing may be submitted with a fence that is still signalled
}

}  // namespace aureole::vulkan
