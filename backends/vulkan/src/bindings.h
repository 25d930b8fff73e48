// Binding sets: descriptor sets from pools that grow when sets are made, never while recording.
#pragma once

#include "context.h"
#include "pipeline.h"

#include <memory>
#include <vector>

namespace aureole::vulkan {

class DescriptorPools {
    struct Pool;

public:
    struct Set {
        Pool* pool = nullptr;
        VkDescriptorSet set = VK_NULL_HANDLE;
    };

    explicit DescriptorPools(const Context& context);
    ~DescriptorPools();
    DescriptorPools(const DescriptorPools&) = delete;
    DescriptorPools& operator=(const DescriptorPools&) = delete;

    /// Throws Error(out_of_memory).
    [[nodiscard]] Set allocate(const ShaderLayout& layout, const std::string& what);
    void free(const Set& set, const ShaderLayout& layout) const noexcept;

private:
    struct Counts {
        std::uint32_t sets = 0, sampled = 0, storage = 0, constants = 0;
        [[nodiscard]] bool holds(const Counts& other) const noexcept;
        void add(const Counts& other, int sign) noexcept;
    };
    [[nodiscard]] static Counts counts_of(const ShaderLayout& layout);
    [[nodiscard]] Pool& add_pool(const Counts& counts, const std::string& what);

    const Context& context_;
    std::vector<std::unique_ptr<Pool>> pools_;
};

/// One slot's native objects.
struct NativeBinding {
    std::uint32_t slot = 0;
    rhi::SlotKind kind = rhi::SlotKind::constants;
    VkDescriptorImageInfo image = {};
    VkDescriptorBufferInfo buffer = {};
};

class BindingSetObject {
public:
    /// Throws Error and leaves nothing behind.
    BindingSetObject(Context& context, DescriptorPools& pools, const std::string& name, const PipelineObject& pipeline,
                     std::span<const NativeBinding> bindings);
    ~BindingSetObject();
    BindingSetObject(const BindingSetObject&) = delete;
    BindingSetObject& operator=(const BindingSetObject&) = delete;

    [[nodiscard]] rhi::BindingSetFacts facts() const noexcept { return {name_, shader_}; }
    [[nodiscard]] VkDescriptorSet set() const noexcept { return set_.set; }

private:
    DescriptorPools& pools_;
    std::string name_;
    const rhi::Shader* shader_;  ///< Lives as long as the program.
    const ShaderLayout& layout_;
    DescriptorPools::Set set_;
};

}  // namespace aureole::vulkan
