#include "bindings.h"

#include "result.h"

#include <algorithm>

namespace aureole::vulkan {

struct DescriptorPools::Pool {
    VkDescriptorPool handle;
    Counts left;
};

DescriptorPools::DescriptorPools(const Context& context) : context_(context) {}

DescriptorPools::~DescriptorPools() {
    for (const auto& pool : pools_) context_.fn.vkDestroyDescriptorPool(context_.device, pool->handle, nullptr);
}

bool DescriptorPools::Counts::holds(const Counts& other) const noexcept {
    return sets >= other.sets && sampled >= other.sampled && storage >= other.storage && constants >= other.constants;
}

void DescriptorPools::Counts::add(const Counts& other, int sign) noexcept {
    const auto move = [&](std::uint32_t& mine, std::uint32_t theirs) { mine = sign > 0 ? mine + theirs : mine - theirs; };
    move(sets, other.sets);
    move(sampled, other.sampled);
    move(storage, other.storage);
    move(constants, other.constants);
}

DescriptorPools::Counts DescriptorPools::counts_of(const ShaderLayout& layout) {
    Counts counts;
    counts.sets = 1;
    for (const auto& [slot, kind] : layout.slots) {
        if (kind == rhi::SlotKind::sampled_texture) ++counts.sampled;
        if (kind == rhi::SlotKind::storage_texture) ++counts.storage;
        if (kind == rhi::SlotKind::constants) ++counts.constants;
    }
    return counts;
}

DescriptorPools::Pool& DescriptorPools::add_pool(const Counts& counts, const std::string& what) {
    const Counts size = {64, std::max(256u, counts.sampled), std::max(64u, counts.storage), std::max(64u, counts.constants)};
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, size.sampled},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, size.storage},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, size.constants}};
    VkDescriptorPoolCreateInfo info = {};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    info.maxSets = size.sets;
    info.poolSizeCount = 3;
    info.pPoolSizes = sizes;
    auto pool = std::make_unique<Pool>(Pool{VK_NULL_HANDLE, size});
    pools_.reserve(pools_.size() + 1);
    check_result(context_.fn.vkCreateDescriptorPool(context_.device, &info, nullptr, &pool->handle), "vkCreateDescriptorPool",
                 what);
    pools_.push_back(std::move(pool));
    return *pools_.back();
}

DescriptorPools::Set DescriptorPools::allocate(const ShaderLayout& layout, const std::string& what) {
    const Counts counts = counts_of(layout);
    VkDescriptorSet set = VK_NULL_HANDLE;
    const auto take_from = [&](Pool& pool) {
        VkDescriptorSetAllocateInfo info = {};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        info.descriptorPool = pool.handle;
        info.descriptorSetCount = 1;
        info.pSetLayouts = &layout.set;
        const VkResult result = context_.fn.vkAllocateDescriptorSets(context_.device, &info, &set);
        if (result == VK_SUCCESS) pool.left.add(counts, -1);
        return result;
    };
    // A pool with enough room by number may still be fragmented: the next one is asked then.
    for (const auto& pool : pools_)
        if (pool->left.holds(counts) && take_from(*pool) == VK_SUCCESS) return {pool.get(), set};
    Pool& pool = add_pool(counts, what);
    check_result(take_from(pool), "vkAllocateDescriptorSets", what);
    return {&pool, set};
}

void DescriptorPools::free(const Set& set, const ShaderLayout& layout) const noexcept {
    context_.fn.vkFreeDescriptorSets(context_.device, set.pool->handle, 1, &set.set);
    set.pool->left.add(counts_of(layout), 1);
}

BindingSetObject::BindingSetObject(Context& context, DescriptorPools& pools, const std::string& name,
                                   const PipelineObject& pipeline, std::span<const NativeBinding> bindings)
    : pools_(pools), name_(name), shader_(&pipeline.shader()), layout_(pipeline.layout()) {
    std::vector<VkWriteDescriptorSet> writes(bindings.size());
    set_ = pools_.allocate(layout_, rhi::field_name("binding set", name_, ""));
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        VkWriteDescriptorSet& write = writes[i];
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set_.set;
        write.dstBinding = bindings[i].slot;
        write.descriptorCount = 1;
        write.descriptorType = descriptor_type(bindings[i].kind);
        write.pImageInfo = &bindings[i].image;
        write.pBufferInfo = &bindings[i].buffer;
    }
    context.fn.vkUpdateDescriptorSets(context.device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
    context.set_name(VK_OBJECT_TYPE_DESCRIPTOR_SET, set_.set, name_);
}

BindingSetObject::~BindingSetObject() { pools_.free(set_, layout_); }

}  // namespace aureole::vulkan
