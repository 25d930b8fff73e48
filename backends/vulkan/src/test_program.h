// A host's own compute shader, with descriptor sets, layouts and pipeline made by hand: nothing of it passes through the
// backend.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "test_host.h"

namespace aureole::vulkan::test {

/// One binding of a set: `image` for samplers and storage images, `buffer` for buffers.
struct ProgramSlot {
    std::uint32_t slot = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    VkDescriptorImageInfo image{};
    VkDescriptorBufferInfo buffer{};
};
using ProgramSet = std::vector<ProgramSlot>;

class HostProgram {
public:
    /// Descriptor sets by number; empty ones may stand between others.
    HostProgram(Host& host, std::span<const std::uint32_t> spirv, const std::vector<ProgramSet>& sets);
    ~HostProgram();
    HostProgram(const HostProgram&) = delete;
    HostProgram& operator=(const HostProgram&) = delete;

    /// Into the host's command buffer.
    void record(std::uint32_t groups_x, std::uint32_t groups_y = 1);

private:
    void make_sets(const std::vector<ProgramSet>& sets);
    void write(VkDescriptorSet set, const ProgramSet& slots);
    void make_pipeline(std::span<const std::uint32_t> spirv);

    Host& host_;
    std::vector<VkDescriptorSetLayout> set_layouts_;
    std::vector<VkDescriptorSet> sets_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// A sampler of the host's, clamping, destroyed by the caller.
[[nodiscard]] VkSampler make_sampler(Host& host, VkFilter filter);

}  // namespace aureole::vulkan::test
