#include "host_vulkan/passes.h"

#include "host_vulkan/pipelines.h"
#include "host_vulkan/rendering.h"

#include <array>

namespace host_vulkan {
namespace {

constexpr VkFormat color_format = VK_FORMAT_R16G16B16A16_SFLOAT, depth_format = VK_FORMAT_D32_SFLOAT;
constexpr VkExtent2D map_extent = {Cascades::count * Cascades::side, Cascades::side};
constexpr VkShaderStageFlags push_stages = VK_SHADER_STAGE_VERTEX_BIT;

#include "shaders/display.frag.h"
#include "shaders/display.vert.h"
#include "shaders/shadow.vert.h"
#include "shaders/sphere.frag.h"
#include "shaders/sphere.vert.h"
#include "shaders/terrain.frag.h"
#include "shaders/terrain.vert.h"

VkSampler make_sampler(const Device& device, bool compare) {
    auto info = info_of<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    VkFormatProperties depth = {};
    vkGetPhysicalDeviceFormatProperties(device.physical, depth_format, &depth);
    if (compare && (depth.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT))
        info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = compare;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkSampler made = VK_NULL_HANDLE;
    check(vkCreateSampler(device.handle, &info, nullptr, &made), "vkCreateSampler");
    return made;
}

template <class T>
std::unique_ptr<Buffer> loaded(const Device& device, const std::vector<T>& contents, VkBufferUsageFlags usage) {
    if (contents.empty()) return nullptr;
    const auto bytes = std::as_bytes(std::span(contents));
    auto buffer = std::make_unique<Buffer>(device, bytes.size(), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, false);
    upload(device, *buffer, bytes);
    return buffer;
}

/// Aureole's constants and the host's own: a pipeline's specialization.
struct Constants {
    std::vector<std::uint32_t> values;
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo info = {};

    void add(std::uint32_t id, std::uint32_t bits) {
        entries.push_back({id, static_cast<std::uint32_t>(values.size() * sizeof(bits)), sizeof(bits)});
        values.push_back(bits);
    }
    [[nodiscard]] const VkSpecializationInfo* get() {
        info = {static_cast<std::uint32_t>(entries.size()), entries.data(), values.size() * sizeof(values[0]), values.data()};
        return &info;
    }
};

}  // namespace

Targets::Targets(const Device& device, VkExtent2D extent)
    : color(device, color_format, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT),
      depth(device, depth_format, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT),
      hdr(device, color_format, extent,
          VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT) {}

Passes::Passes(const Device& device, const Sky& sky, const TerrainMesh& mesh, const Swapchain& swapchain, std::uint32_t frames,
               std::uint32_t spheres)
    : device_(device),
      sky_set_(sky.set()),
      index_count_(static_cast<std::uint32_t>(mesh.indices.size())),
      spheres_(spheres),
      shadow_map_(device, depth_format, map_extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                  true),
      vertices_(loaded(device, mesh.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      indices_(loaded(device, mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
      compare_(make_sampler(device, true)),
      nearest_(make_sampler(device, false)) {
    make_sets(frames);
    make_pipelines(sky, swapchain);
}

Passes::~Passes() {
    for (const VkPipeline pipeline : {shadow_, depth_, color_, sphere_, display_})
        vkDestroyPipeline(device_.handle, pipeline, nullptr);
    vkDestroyPipelineLayout(device_.handle, layout_, nullptr);
    vkDestroyDescriptorPool(device_.handle, pool_, nullptr);
    vkDestroyDescriptorSetLayout(device_.handle, set_layout_, nullptr);
    vkDestroySampler(device_.handle, compare_, nullptr);
    vkDestroySampler(device_.handle, nearest_, nullptr);
}

void Passes::make_sets(std::uint32_t frames) {
    constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorSetLayoutBinding bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, stages, nullptr},
        {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr},
        {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr}};
    auto layout = info_of<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    layout.bindingCount = 3;
    layout.pBindings = bindings;
    check(vkCreateDescriptorSetLayout(device_.handle, &layout, nullptr, &set_layout_), "vkCreateDescriptorSetLayout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, frames},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2 * frames}};
    auto pool = info_of<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool.maxSets = frames;
    pool.poolSizeCount = 2;
    pool.pPoolSizes = sizes;
    check(vkCreateDescriptorPool(device_.handle, &pool, nullptr, &pool_), "vkCreateDescriptorPool");
}

VkDescriptorSet Passes::make_set(const Buffer& uniforms) const {
    auto allocate = info_of<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocate.descriptorPool = pool_;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set_layout_;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device_.handle, &allocate, &set), "vkAllocateDescriptorSets");
    const VkDescriptorBufferInfo block = {uniforms.buffer, 0, VK_WHOLE_SIZE};
    const VkDescriptorImageInfo map = {compare_, shadow_map_.view, uses::depth_read.layout};
    std::array<VkWriteDescriptorSet, 2> writes = {};
    for (std::uint32_t i = 0; i < 2; ++i) {
        writes[i] = info_of<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        writes[i].dstSet = set;
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
    }
    writes[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    writes[0].pBufferInfo = &block;
    writes[1].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[1].pImageInfo = &map;
    vkUpdateDescriptorSets(device_.handle, 2, writes.data(), 0, nullptr);
    return set;
}

void Passes::show(VkDescriptorSet set, const Image& hdr) const {
    const VkDescriptorImageInfo image = {nearest_, hdr.view, uses::sampled.layout};
    auto write = info_of<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    write.dstSet = set;
    write.dstBinding = 2;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    vkUpdateDescriptorSets(device_.handle, 1, &write, 0, nullptr);
}

void Passes::make_pipelines(const Sky& sky, const Swapchain& swapchain) {
    const VkDescriptorSetLayout sets[] = {set_layout_, sky.set_layout()};
    const VkPushConstantRange push = {push_stages, 0, sizeof(std::int32_t)};
    auto layout = info_of<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    layout.setLayoutCount = 2;
    layout.pSetLayouts = sets;
    layout.pushConstantRangeCount = 1;
    layout.pPushConstantRanges = &push;
    check(vkCreatePipelineLayout(device_.handle, &layout, nullptr, &layout_), "vkCreatePipelineLayout");

    Constants lit, own;
    for (const aureole::rhi::Specialization& constant : sky.constants()) lit.add(constant.id, constant.bits);
    lit.add(1000, sky.has_shafts());
    own.add(0, !swapchain.encodes());

    PipelineDesc shadow{.vertex = shadow_vert, .layout = layout_, .depth = depth_format, .mesh_attributes = 1};
    shadow.compare = VK_COMPARE_OP_LESS;
    shadow.write_depth = shadow.clamp_depth = true;
    shadow_ = make_pipeline(device_, shadow);
    PipelineDesc depth{.vertex = terrain_vert, .layout = layout_, .depth = depth_format, .mesh_attributes = 3};
    depth.compare = VK_COMPARE_OP_GREATER;
    depth.write_depth = true;
    depth_ = make_pipeline(device_, depth);
    PipelineDesc color = depth;
    color.fragment = terrain_frag;
    color.color = color_format;
    color.compare = VK_COMPARE_OP_EQUAL;
    color.write_depth = false;
    color.constants = lit.get();
    color_ = make_pipeline(device_, color);
    PipelineDesc sphere{.vertex = sphere_vert, .fragment = sphere_frag, .layout = layout_, .color = color_format};
    sphere.depth = depth_format;
    sphere.compare = VK_COMPARE_OP_GREATER;
    sphere.blend = true;
    sphere.constants = lit.get();
    sphere_ = make_pipeline(device_, sphere);
    PipelineDesc display{.vertex = display_vert, .fragment = display_frag, .layout = layout_, .color = swapchain.format()};
    display.constants = own.get();
    display_ = make_pipeline(device_, display);
}

void Passes::begin(VkCommandBuffer commands, VkDescriptorSet set, VkPipeline pipeline) const {
    const VkDescriptorSet sets[] = {set, sky_set_};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 2, sets, 0, nullptr);
}

void Passes::draw_mesh(VkCommandBuffer commands) const {
    if (!vertices_) return;
    const VkDeviceSize start = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices_->buffer, &start);
    vkCmdBindIndexBuffer(commands, indices_->buffer, 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, index_count_, 1, 0, 0, 0);
}

void Passes::record_shadows(VkCommandBuffer commands, VkDescriptorSet set) {
    shadow_map_.move(commands, uses::depth_attachment, false);
    begin_rendering(commands, map_extent, {}, {shadow_map_.view, uses::depth_attachment.layout, Load::clear, 1});
    begin(commands, set, shadow_);
    for (std::int32_t c = 0; c < static_cast<std::int32_t>(Cascades::count); ++c) {
        constexpr auto side = static_cast<std::int32_t>(Cascades::side);
        set_viewport(commands, {{c * side, 0}, {Cascades::side, Cascades::side}}, false);
        vkCmdPushConstants(commands, layout_, push_stages, 0, sizeof(c), &c);
        draw_mesh(commands);
    }
    vkCmdEndRendering(commands);
    shadow_map_.move(commands, uses::depth_read, true);
}

void Passes::record_depth(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const {
    const VkExtent2D extent = targets.depth.extent;
    targets.depth.move(commands, uses::depth_attachment, false);
    begin_rendering(commands, extent, {}, {targets.depth.view, uses::depth_attachment.layout, Load::clear, 0});
    begin(commands, set, depth_);
    set_viewport(commands, {{0, 0}, extent}, true);
    draw_mesh(commands);
    vkCmdEndRendering(commands);
    targets.depth.move(commands, uses::depth_read, true);
}

void Passes::record_color(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const {
    const VkExtent2D extent = targets.color.extent;
    targets.color.move(commands, uses::color_attachment, false);
    begin_rendering(commands, extent, {targets.color.view, uses::color_attachment.layout, Load::clear, 0},
                    {targets.depth.view, uses::depth_read.layout, Load::keep, 0});
    begin(commands, set, color_);
    set_viewport(commands, {{0, 0}, extent}, true);
    draw_mesh(commands);
    vkCmdEndRendering(commands);
    targets.color.move(commands, uses::sampled, true);
}

void Passes::record_transparents(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets) const {
    const VkExtent2D extent = targets.hdr.extent;
    targets.hdr.move(commands, uses::color_attachment, true);
    begin_rendering(commands, extent, {targets.hdr.view, uses::color_attachment.layout, Load::keep, 0},
                    {targets.depth.view, uses::depth_read.layout, Load::keep, 0});
    begin(commands, set, sphere_);
    set_viewport(commands, {{0, 0}, extent}, true);
    if (spheres_ > 0) vkCmdDraw(commands, 6, spheres_, 0, 0);
    vkCmdEndRendering(commands);
}

void Passes::record_display(VkCommandBuffer commands, VkDescriptorSet set, Targets& targets, VkImageView target) const {
    const VkExtent2D extent = targets.hdr.extent;
    targets.hdr.move(commands, uses::sampled, true);
    begin_rendering(commands, extent, {target, uses::color_attachment.layout, Load::discard, 0}, {});
    begin(commands, set, display_);
    set_viewport(commands, {{0, 0}, extent}, false);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

}  // namespace host_vulkan
