// Aureole in this host: all that there is to it is in this file and in sky.cpp. The rest of the renderer knows images, a
// descriptor set and a list of specialization constants.
#pragma once

#include "host_vulkan/cascades.h"
#include "host_vulkan/resources.h"
#include "scene/scene.h"

#include <aureole/atmosphere.h>
#include <aureole/vulkan/vulkan_device.h>

#include <memory>
#include <span>
#include <vector>

namespace host_vulkan {

class Sky {
public:
    /// Throws aureole::Error: what the device lacks, or a model of the scene without the tables that the shaders look up.
    Sky(const Device& device, const aureole::app::Scene& scene);
    ~Sky();
    Sky(const Sky&) = delete;
    Sky& operator=(const Sky&) = delete;

    // Once, and at every change of the window's size. The device has finished all frames before textures are taken back.
    void lend_shadow_map(const Image& map);
    void lend_targets(const Image& color, const Image& depth, const Image& target);
    void take_targets_back();

    // Each frame, in this order. The images are in the states in which they were lent: depth and the shadow map in
    // uses::depth_read, colour in uses::sampled, the target in uses::storage_write; and they stay in them.
    void update(std::uint64_t frame, const aureole::Camera& camera, std::span<const aureole::Sun> suns,
                const Cascades& cascades);
    /// Reads the shadow map. For a queue of this family: the device's own, or that of its compute queue.
    void record_tables(VkCommandBuffer commands, std::uint32_t queue_family);
    void record_composite(VkCommandBuffer commands);  ///< Reads colour and depth, writes all of the target.
    void finished(std::uint64_t frame);               ///< Once its fence has been signalled.

    // For shaders that include aureole.glsl: set AUREOLE_SET, and the constants of their pipelines.
    [[nodiscard]] VkDescriptorSetLayout set_layout() const noexcept { return layout_; }
    [[nodiscard]] VkDescriptorSet set() const noexcept { return set_; }
    [[nodiscard]] std::span<const aureole::rhi::Specialization> constants() const noexcept { return constants_; }
    [[nodiscard]] bool has_shafts() const noexcept { return shafts_; }

private:
    aureole::rhi::Texture lend(const char* name, const Image& image, aureole::rhi::Format format, aureole::rhi::Usage usage,
                               aureole::rhi::State state);
    void make_set();

    const Device& device_;
    bool shafts_;
    std::unique_ptr<aureole::vulkan::BorrowedVulkanDevice> guest_;
    std::unique_ptr<aureole::Atmosphere> air_;
    std::unique_ptr<aureole::View> view_;
    aureole::CompositeTargets targets_;
    aureole::ShadowMap shadow_map_;
    std::uint64_t frame_ = 0;

    std::vector<aureole::rhi::Specialization> constants_;
    VkSampler linear_ = VK_NULL_HANDLE, nearest_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace host_vulkan
