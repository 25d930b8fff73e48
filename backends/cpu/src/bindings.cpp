#include "bindings.h"

#include <algorithm>
#include <utility>

namespace aureole::cpu {

BindingsObject::BindingsObject(std::string name, const rhi::Shader& shader) : name_(std::move(name)), shader_(&shader) {
    std::uint32_t count = 0;
    for (const rhi::SlotDesc& slot : shader.slots) count = std::max(count, slot.slot + 1);
    bindings_.resize(count);
}

void BindingsObject::set_texture(const rhi::SlotDesc& slot, std::shared_ptr<TextureObject> texture,
                                 const rhi::SamplerDesc& sampler) {
    rhi::CpuBinding binding = texture->binding();
    binding.kind = slot.kind;
    binding.filter = sampler.filter;
    binding.address_u = sampler.address_u, binding.address_v = sampler.address_v, binding.address_w = sampler.address_w;
    bindings_[slot.slot] = binding;
    if (texture->of_host()) host_textures_.push_back({texture.get(), slot.kind == rhi::SlotKind::storage_texture});
    textures_.push_back(std::move(texture));
}

void BindingsObject::set_constants(const rhi::SlotDesc& slot, std::shared_ptr<BufferObject> buffer) {
    rhi::CpuBinding& binding = bindings_[slot.slot];
    binding.kind = rhi::SlotKind::constants;
    binding.constants = buffer->bytes().data();
    binding.constants_size = buffer->bytes().size();
    buffers_.push_back(std::move(buffer));
}

}  // namespace aureole::cpu
