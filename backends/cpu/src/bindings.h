// A binding set on the CPU: what the kernels see in each slot. Keeps its textures and buffers alive.
#pragma once

#include <aureole/rhi/checks.h>
#include <aureole/rhi/shader.h>

#include <memory>
#include <string>
#include <vector>

#include "buffer.h"
#include "texture.h"

namespace aureole::cpu {

class BindingsObject {
public:
    BindingsObject(std::string name, const rhi::Shader& shader);

    void set_texture(const rhi::SlotDesc& slot, std::shared_ptr<TextureObject> texture, const rhi::SamplerDesc& sampler);
    void set_constants(const rhi::SlotDesc& slot, std::shared_ptr<BufferObject> buffer);

    [[nodiscard]] rhi::BindingSetFacts facts() const noexcept { return {name_, shader_}; }
    [[nodiscard]] std::span<const rhi::CpuBinding> bindings() const noexcept { return bindings_; }
    /// Those of `bindings()` that are textures of the host's.
    struct HostTexture {
        TextureObject* texture;
        bool written;
    };
    [[nodiscard]] std::span<const HostTexture> host_textures() const noexcept { return host_textures_; }

private:
    std::string name_;
    const rhi::Shader* shader_;
    std::vector<rhi::CpuBinding> bindings_;  // by slot
    std::vector<HostTexture> host_textures_;
    std::vector<std::shared_ptr<TextureObject>> textures_;
    std::vector<std::shared_ptr<BufferObject>> buffers_;
};

}  // namespace aureole::cpu
