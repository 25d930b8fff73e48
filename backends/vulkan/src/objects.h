// Handles and the objects behind them, and the objects that wait for the device to finish before they go.
#pragma once

#include "bindings.h"
#include "buffer.h"
#include "pipeline.h"
#include "sampler.h"
#include "texture.h"

#include <aureole/rhi/checks.h>

#include <memory>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace aureole::vulkan {

/// Handles count up and are never reused. Looking one up allocates nothing.
template <class Tag, class Object>
class Registry {
public:
    [[nodiscard]] rhi::Handle<Tag> add(std::unique_ptr<Object> object) {
        objects_.emplace(next_, std::move(object));
        return {next_++};
    }
    [[nodiscard]] Object* find(rhi::Handle<Tag> handle) const noexcept {
        const auto at = objects_.find(handle.value);
        return at == objects_.end() ? nullptr : at->second.get();
    }
    /// Null for unknown handles.
    [[nodiscard]] std::unique_ptr<Object> take(rhi::Handle<Tag> handle) noexcept {
        const auto node = objects_.extract(handle.value);
        return node.empty() ? nullptr : std::move(node.mapped());
    }
    template <class Visitor>
    void for_each(Visitor&& visit) const {
        for (const auto& [value, object] : objects_) visit(*object);
    }

private:
    std::unordered_map<std::uint64_t, std::unique_ptr<Object>> objects_;
    std::uint64_t next_ = 1;
};

/// Everything made from a device.
class Objects final : public rhi::ObjectLookup {
public:
    Registry<rhi::TextureTag, TextureObject> textures;
    Registry<rhi::BufferTag, BufferObject> buffers;
    Registry<rhi::SamplerTag, SamplerObject> samplers;
    Registry<rhi::PipelineTag, PipelineObject> pipelines;
    Registry<rhi::BindingSetTag, BindingSetObject> binding_sets;

    [[nodiscard]] const rhi::TextureDesc* find(rhi::Texture handle) const override { return desc_of(textures.find(handle)); }
    [[nodiscard]] const rhi::BufferDesc* find(rhi::Buffer handle) const override { return desc_of(buffers.find(handle)); }
    [[nodiscard]] const rhi::SamplerDesc* find(rhi::Sampler handle) const override { return desc_of(samplers.find(handle)); }

    /// False if the handle is not null and unknown.
    bool destroy(rhi::AnyHandle handle, std::uint64_t last_used_frame);
    void collect(std::uint64_t completed_frame) noexcept;

    /// Every texture that is still there, destroyed ones that wait for their last frame included.
    template <class Visitor>
    void for_each_texture(Visitor&& visit) const {
        textures.for_each(visit);
        for (const auto& [frame, object] : doomed_)
            if (const auto* texture = std::get_if<std::unique_ptr<TextureObject>>(&object)) visit(**texture);
    }

private:
    auto& registry_of(rhi::Texture) noexcept { return textures; }
    auto& registry_of(rhi::Buffer) noexcept { return buffers; }
    auto& registry_of(rhi::Sampler) noexcept { return samplers; }
    auto& registry_of(rhi::Pipeline) noexcept { return pipelines; }
    auto& registry_of(rhi::BindingSet) noexcept { return binding_sets; }

    template <class Object>
    [[nodiscard]] static auto desc_of(const Object* object) noexcept -> decltype(&object->desc()) {
        return object ? &object->desc() : nullptr;
    }

    using AnyObject =
        std::variant<std::unique_ptr<TextureObject>, std::unique_ptr<BufferObject>, std::unique_ptr<SamplerObject>,
                     std::unique_ptr<PipelineObject>, std::unique_ptr<BindingSetObject>>;
    std::vector<std::pair<std::uint64_t, AnyObject>> doomed_;  ///< With the frame after which nobody uses them.
};

}  // namespace aureole::vulkan
