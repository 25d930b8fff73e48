#include "host_vulkan/sky.h"

#include "common/scene_settings.h"
#include "host_vulkan/calls.h"

#include <array>
#include <cstdio>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

namespace host_vulkan {
namespace {

using namespace aureole;

constexpr std::uint32_t slots = 8;  // of aureole.glsl: two blocks, then six tables

void on_message(void*, rhi::Severity severity, const char* text) {
    if (severity != rhi::Severity::info) std::fprintf(stderr, "aureole: %s\n", text);
}

vulkan::BorrowedVulkan borrowed(const Device& device) {
    vulkan::BorrowedVulkan host;
    host.instance = device.instance;
    host.physical_device = device.physical;
    host.device = device.handle;
    host.get_instance_proc_addr = counted_proc_addr;  // the host's own way to Vulkan: hooks see Aureole's calls, too
    host.api_version = api_version;
    host.queue_family = device.family;
    host.second_queue_family = device.compute_family;
    host.enabled_features = device.features;
    host.debug_utils = device.validated;
    return host;
}

VkSampler make_sampler(VkDevice device, VkFilter filter) {
    auto info = info_of<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = filter;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSampler made = VK_NULL_HANDLE;
    check(vkCreateSampler(device, &info, nullptr, &made), "vkCreateSampler");
    return made;
}

}  // namespace

Sky::Sky(const Device& device, const app::Scene& scene)
    : device_(device), shafts_(app::shadows_air(scene)), guest_(vulkan::borrow_vulkan_device(borrowed(device))) {
    guest_->device().set_message_callback(on_message, nullptr);
    air_ = std::make_unique<Atmosphere>(guest_->device(), scene.atmosphere, scene.model.make());
    CompositeSettings composite = app::composite_settings(scene, true);
    composite.target_format = rhi::Format::rgba16_float;  // the host's HDR target
    view_ = std::make_unique<View>(*air_, app::view_settings(scene, true, Cascades::count), composite);
    if (!view_->sky_view_table() || !view_->aerial_perspective_table())
        throw Error(ErrorCode::unsupported, "model", scene.model.describe(),
                    "one that keeps tables for a host's shaders: aureole, or hillaire in its qualities low and default");
    constants_ = view_->shader_constants();
    make_set();
}

/// The device is idle. Views go before their atmosphere, and both before their device.
Sky::~Sky() {
    if (targets_.target) take_targets_back();
    view_.reset();
    air_.reset();
    guest_.reset();
    vkDestroyDescriptorPool(device_.handle, pool_, nullptr);
    vkDestroyDescriptorSetLayout(device_.handle, layout_, nullptr);
    vkDestroySampler(device_.handle, linear_, nullptr);
    vkDestroySampler(device_.handle, nearest_, nullptr);
}

/// Tables and blocks stay the same objects for as long as the air keeps its structure, so one set serves all frames.
void Sky::make_set() {
    linear_ = make_sampler(device_.handle, VK_FILTER_LINEAR);
    nearest_ = make_sampler(device_.handle, VK_FILTER_NEAREST);
    std::array<VkDescriptorSetLayoutBinding, slots> bindings = {};
    for (std::uint32_t i = 0; i < slots; ++i)
        bindings[i] = {i, i < 2 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                       VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    auto layout = info_of<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    layout.bindingCount = slots;
    layout.pBindings = bindings.data();
    check(vkCreateDescriptorSetLayout(device_.handle, &layout, nullptr, &layout_), "vkCreateDescriptorSetLayout");
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, slots - 2}};
    auto pool = info_of<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool.maxSets = 1;
    pool.poolSizeCount = 2;
    pool.pPoolSizes = sizes;
    check(vkCreateDescriptorPool(device_.handle, &pool, nullptr, &pool_), "vkCreateDescriptorPool");
    auto allocate = info_of<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocate.descriptorPool = pool_;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout_;
    check(vkAllocateDescriptorSets(device_.handle, &allocate, &set_), "vkAllocateDescriptorSets");

    const std::array<VkDescriptorBufferInfo, 2> blocks = {
        {{guest_->native(view_->air_block()), 0, VK_WHOLE_SIZE}, {guest_->native(view_->view_block()), 0, VK_WHOLE_SIZE}}};
    const std::array<std::pair<rhi::Texture, VkSampler>, slots - 2> tables = {{{view_->sky_view_table(), linear_},
                                                                               {air_->transmittance_table(), linear_},
                                                                               {view_->aerial_perspective_table(), linear_},
                                                                               {view_->light_table(), nearest_},
                                                                               {view_->phase_table(), nearest_},
                                                                               {view_->profile_table(), nearest_}}};
    std::array<VkDescriptorImageInfo, slots - 2> images = {};
    std::array<VkWriteDescriptorSet, slots> writes = {};
    for (std::uint32_t i = 0; i < slots; ++i) {
        writes[i] = info_of<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        writes[i].dstSet = set_;
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = bindings[i].descriptorType;
        if (i < 2) {
            writes[i].pBufferInfo = &blocks[i];
            continue;
        }
        const vulkan::NativeTexture table = guest_->native(tables[i - 2].first);
        images[i - 2] = {tables[i - 2].second, table.sampled_view, table.sampled_layout};
        writes[i].pImageInfo = &images[i - 2];
    }
    vkUpdateDescriptorSets(device_.handle, slots, writes.data(), 0, nullptr);
}

rhi::Texture Sky::lend(const char* name, const Image& image, rhi::Format format, rhi::Usage usage, rhi::State state) {
    rhi::ExternalTexture external;
    external.desc = {name, rhi::Dimension::d2, format, {image.extent.width, image.extent.height, 1}, usage};
    external.native = (std::uint64_t)image.image;  // a pointer or a number, by platform
    external.state = state;
    return guest_->device().wrap_texture(external);
}

void Sky::lend_shadow_map(const Image& map) {
    shadow_map_.texture = lend("host's shadow map", map, rhi::Format::d32_float, rhi::Usage::sampled, rhi::State::depth_read);
}

void Sky::lend_targets(const Image& color, const Image& depth, const Image& target) {
    targets_.scene_color = lend("host's colour", color, rhi::Format::rgba16_float, rhi::Usage::sampled, rhi::State::sampled);
    targets_.scene_depth = lend("host's depth", depth, rhi::Format::d32_float, rhi::Usage::sampled, rhi::State::depth_read);
    targets_.target = lend("host's target", target, rhi::Format::rgba16_float, rhi::Usage::storage, rhi::State::storage_write);
    targets_.extent = {target.extent.width, target.extent.height, 1};
    view_->prepare_composite(targets_);
}

void Sky::take_targets_back() {
    view_->release_composite(targets_);
    for (const rhi::Texture texture : {targets_.scene_color, targets_.scene_depth, targets_.target})
        guest_->device().destroy(texture, frame_);
    guest_->device().collect(frame_);
    targets_ = {};
}

void Sky::update(std::uint64_t frame, const Camera& camera, std::span<const Sun> suns, const Cascades& cascades) {
    frame_ = frame;
    air_->set_frame(frame);
    if (shafts_) {
        for (std::size_t c = 0; c < Cascades::count; ++c)
            shadow_map_.world_to_map[c] = glm::translate(cascades.camera_to_map[c], -camera.position_m);
        shadow_map_.bias = cascades.texel_m.back() / cascades.depth_m;
        view_->set_shadow_map(shadow_map_);
    }
    view_->update(camera, suns);
}

void Sky::record_tables(VkCommandBuffer commands, std::uint32_t queue_family) {
    rhi::CommandList& list = guest_->begin_recording(commands, queue_family);
    air_->record(list);
    view_->record(list);
    guest_->end_recording();
}

void Sky::record_composite(VkCommandBuffer commands) {
    rhi::CommandList& list = guest_->begin_recording(commands);
    view_->record_composite(list, targets_);
    guest_->end_recording();
}

void Sky::finished(std::uint64_t frame) { guest_->device().collect(frame); }

}  // namespace host_vulkan
