// A host on Vulkan with instance, device, samplers, descriptor sets and a shader of its own, and Aureole as its guest.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "host/host_shader.h"
#include "host/scenes.h"
#include "test_program.h"
#include "test_queue.h"

namespace aureole::host {

/// Host and guest, for a passes::Backend: what the tests of the passes can do works on the host's device too.
class OpenHost final : public passes::OpenDevice {
public:
    explicit OpenHost(vulkan::test::Host& host);
    ~OpenHost() override;
    [[nodiscard]] rhi::Device& device() override { return guest_->device(); }
    [[nodiscard]] rhi::Queue& queue() override { return queue_; }
    [[nodiscard]] vulkan::test::HostQueue& host_queue() { return queue_; }
    [[nodiscard]] const vulkan::BorrowedVulkanDevice& guest() const { return *guest_; }
    [[nodiscard]] vulkan::test::Host& host() const { return host_; }
    [[nodiscard]] VkSampler linear() const { return linear_; }
    [[nodiscard]] VkSampler nearest() const { return nearest_; }

private:
    vulkan::test::Host& host_;
    std::unique_ptr<vulkan::BorrowedVulkanDevice> guest_;
    vulkan::test::HostQueue queue_;
    VkSampler linear_, nearest_;
};

/// The host's shader with its sets: 0 is its own, `shader.set` Aureole's, filled with the native objects of a rig's tables.
class Asker {
public:
    Asker(const OpenHost& open, const passes::Rig& rig, HostShader shader, std::span<const Question> questions);

    /// Into the host's command buffer.
    void record();
    /// After the host has submitted and waited.
    [[nodiscard]] std::vector<Answer> answers() const;

private:
    [[nodiscard]] vulkan::test::ProgramSet own_set(std::span<const Question> questions) const;
    [[nodiscard]] vulkan::test::ProgramSet aureole_set(const OpenHost& open, const passes::Rig& rig, int first_slot) const;

    vulkan::test::Host& host_;
    std::uint32_t count_;
    vulkan::test::HostBuffer& answers_;
    std::unique_ptr<vulkan::test::HostProgram> program_;
};

}  // namespace aureole::host
