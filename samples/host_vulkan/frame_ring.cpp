#include "host_vulkan/frame_ring.h"

#include <initializer_list>
#include <limits>

namespace host_vulkan {
namespace {

VkSemaphoreSubmitInfo at(VkSemaphore semaphore, VkPipelineStageFlags2 stages) {
    auto info = info_of<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO);
    info.semaphore = semaphore;
    info.stageMask = stages;
    return info;
}

VkCommandBufferSubmitInfo of(VkCommandBuffer commands) {
    auto info = info_of<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
    info.commandBuffer = commands;
    return info;
}

void submit_one(VkQueue queue, std::span<const VkSemaphoreSubmitInfo> waits,
                std::span<const VkCommandBufferSubmitInfo> commands, std::span<const VkSemaphoreSubmitInfo> signals,
                VkFence fence) {
    auto info = info_of<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    info.waitSemaphoreInfoCount = static_cast<std::uint32_t>(waits.size());
    info.pWaitSemaphoreInfos = waits.data();
    info.commandBufferInfoCount = static_cast<std::uint32_t>(commands.size());
    info.pCommandBufferInfos = commands.data();
    info.signalSemaphoreInfoCount = static_cast<std::uint32_t>(signals.size());
    info.pSignalSemaphoreInfos = signals.data();
    check(vkQueueSubmit2(queue, 1, &info, fence), "vkQueueSubmit2");
}

constexpr VkPipelineStageFlags2 everything = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;

}  // namespace

FrameRing::FrameRing(const Device& device, std::uint32_t frames, bool async_compute, VkDeviceSize uniform_bytes)
    : device_(device), async_(async_compute), frames_(frames) {
    for (Frame& frame : frames_) make(frame, uniform_bytes);
}

void FrameRing::make_commands(Frame& frame) const {
    const auto allocate = [&](VkCommandPool& pool, std::uint32_t family, std::initializer_list<VkCommandBuffer*> buffers) {
        auto info = info_of<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
        info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
        info.queueFamilyIndex = family;
        check(vkCreateCommandPool(device_.handle, &info, nullptr, &pool), "vkCreateCommandPool");
        auto one = info_of<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
        one.commandPool = pool;
        one.commandBufferCount = 1;
        for (VkCommandBuffer* made : buffers)
            check(vkAllocateCommandBuffers(device_.handle, &one, made), "vkAllocateCommandBuffers");
    };
    FrameCommands& parts = frame.commands;
    if (async_) {
        allocate(frame.pool, device_.family, {&parts.shadows, &parts.depth, &parts.picture});
        allocate(frame.compute_pool, device_.compute_family, {&parts.tables});
    } else {
        allocate(frame.pool, device_.family, {&parts.shadows});
        parts.tables = parts.depth = parts.picture = parts.shadows;
    }
}

void FrameRing::make(Frame& frame, VkDeviceSize uniform_bytes) {
    make_commands(frame);
    const auto semaphore = info_of<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    for (VkSemaphore* made : {&frame.acquired, &frame.shadows_done, &frame.tables_done})
        check(vkCreateSemaphore(device_.handle, &semaphore, nullptr, made), "vkCreateSemaphore");
    auto fence = info_of<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
    check(vkCreateFence(device_.handle, &fence, nullptr, &frame.done), "vkCreateFence");
    frame.uniforms = std::make_unique<Buffer>(device_, uniform_bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, true);
}

FrameRing::~FrameRing() {
    for (Frame& frame : frames_) {
        vkDestroyCommandPool(device_.handle, frame.pool, nullptr);
        vkDestroyCommandPool(device_.handle, frame.compute_pool, nullptr);
        for (const VkSemaphore semaphore : {frame.acquired, frame.shadows_done, frame.tables_done})
            vkDestroySemaphore(device_.handle, semaphore, nullptr);
        vkDestroyFence(device_.handle, frame.done, nullptr);
    }
}

Frame& FrameRing::wait() {
    Frame& frame = frames_[next_];
    check(vkWaitForFences(device_.handle, 1, &frame.done, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
          "vkWaitForFences");
    return frame;
}

void FrameRing::begin(Frame& frame, std::uint64_t number) {
    next_ = (next_ + 1) % frames_.size();
    frame.number = number;
    check(vkResetFences(device_.handle, 1, &frame.done), "vkResetFences");
    check(vkResetCommandPool(device_.handle, frame.pool, 0), "vkResetCommandPool");
    if (async_) check(vkResetCommandPool(device_.handle, frame.compute_pool, 0), "vkResetCommandPool");
    auto info = info_of<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(frame.commands.shadows, &info), "vkBeginCommandBuffer");
    if (!async_) return;
    for (const VkCommandBuffer part : {frame.commands.tables, frame.commands.depth, frame.commands.picture})
        check(vkBeginCommandBuffer(part, &info), "vkBeginCommandBuffer");
}

void FrameRing::submit(Frame& frame, const Swapchain::Target& target) const {
    check(vkEndCommandBuffer(frame.commands.shadows), "vkEndCommandBuffer");
    const VkCommandBufferSubmitInfo shadows = of(frame.commands.shadows);
    const VkSemaphoreSubmitInfo acquired = at(frame.acquired, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT);
    const VkSemaphoreSubmitInfo rendered = at(target.rendered, everything);
    if (!async_) return submit_one(device_.queue, {&acquired, 1}, {&shadows, 1}, {&rendered, 1}, frame.done);

    for (const VkCommandBuffer part : {frame.commands.tables, frame.commands.depth, frame.commands.picture})
        check(vkEndCommandBuffer(part), "vkEndCommandBuffer");
    const VkSemaphoreSubmitInfo shadows_done = at(frame.shadows_done, everything);
    const VkSemaphoreSubmitInfo tables_done = at(frame.tables_done, everything);
    const VkSemaphoreSubmitInfo waits[] = {acquired, tables_done};
    const VkCommandBufferSubmitInfo tables = of(frame.commands.tables), depth = of(frame.commands.depth),
                                    picture = of(frame.commands.picture);
    submit_one(device_.queue, {}, {&shadows, 1}, {&shadows_done, 1}, VK_NULL_HANDLE);
    submit_one(device_.compute_queue, {&shadows_done, 1}, {&tables, 1}, {&tables_done, 1}, VK_NULL_HANDLE);
    submit_one(device_.queue, {}, {&depth, 1}, {}, VK_NULL_HANDLE);
    submit_one(device_.queue, waits, {&picture, 1}, {&rendered, 1}, frame.done);
}

}  // namespace host_vulkan
