// What the host draws: shadow maps, depth, the land's colour, glass balls, and the window's picture.
#pragma once

#include "host_vulkan/cascades.h"
#include "host_vulkan/sky.h"
#include "host_vulkan/swapchain.h"
#include "host_vulkan/terrain_mesh.h"

#include <glm/mat4x4.hpp>
#include <vector>

namespace host_vulkan {

constexpr std::uint32_t most_suns = 4, most_spheres = 8;

/// Uniforms of a frame: as shaders/frame.glsl has them.
struct FrameBlock {
    glm::mat4 camera_to_clip;
    glm::mat4 camera_to_map[Cascades::count];
    glm::vec4 mesh_origin, up, suns[most_suns], texel_m, counts, spheres[most_spheres];
};

/// The images of one size.
struct Targets {
    Targets(const Device& device, VkExtent2D extent);
    Image color;  ///< The land, lit: scene-linear.
    Image depth;  ///< Reversed.
    Image hdr;    ///< With sky and air, then with what is transparent.
};

class Passes {
public:
    Passes(const Device& device, const Sky& sky, const TerrainMesh& mesh, const Swapchain& swapchain, std::uint32_t frames,
           std::uint32_t spheres);
    ~Passes();
    Passes(const Passes&) = delete;
    Passes& operator=(const Passes&) = delete;

    /// The host's set for a frame, with these uniforms.
    [[nodiscard]] VkDescriptorSet make_set(const Buffer& uniforms) const;
    /// The picture that the display pass of this set shows.
    void show(VkDescriptorSet set, const Image& hdr) const;

    // Each leaves its image as the next one wants it: the shadow map and depth in uses::depth_read, colour in uses::sampled.
    void record_shadows(VkCommandBuffer commands, VkDescriptorSet set);
    void record_depth(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const;
    void record_color(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const;
    void record_transparents(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const;
    void record_display(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets, VkImageView target) const;

    [[nodiscard]] Image& shadow_map() noexcept { return shadow_map_; }

private:
    void make_sets(std::uint32_t frames);
    void make_pipelines(const Sky& sky, const Swapchain& swapchain);
    void begin(VkCommandBuffer commands, VkDescriptorSet set, VkPipeline pipeline) const;
    void draw_mesh(VkCommandBuffer commands) const;

    const Device& device_;
    const VkDescriptorSet sky_set_;
    const std::uint32_t index_count_, spheres_;
    Image shadow_map_;
    std::unique_ptr<Buffer> vertices_, indices_;  ///< Null without land.
    VkSampler compare_ = VK_NULL_HANDLE, nearest_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline shadow_ = VK_NULL_HANDLE, depth_ = VK_NULL_HANDLE, color_ = VK_NULL_HANDLE, sphere_ = VK_NULL_HANDLE,
               display_ = VK_NULL_HANDLE;
};

}  // namespace host_vulkan
