// OpenGL objects behind the interface's handles. They are made and destroyed with the context current.
#pragma once

#include <aureole/rhi/checks.h>
#include <aureole/rhi/device.h>
#include <epoxy/gl.h>

#include <memory>
#include <string>
#include <vector>

namespace aureole::gl {

class TextureObject {
public:
    explicit TextureObject(const rhi::TextureDesc& desc);
    /// A texture of the host's, which stays when this one goes. Throws Error(invalid_argument) unless it is what `external`
    /// says.
    explicit TextureObject(const rhi::ExternalTexture& external);
    ~TextureObject();
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;

    const rhi::TextureDesc desc;
    const GLenum target;
    GLuint name = 0;
    GLuint image = 0;        ///< What image units take: kernels see the faces of a cube as layers.
    GLuint framebuffer = 0;  ///< With this texture as its target, if it can be drawn to.

private:
    void make_uses();
    void release() noexcept;
    bool owned_;
};

struct BufferObject {
    explicit BufferObject(const rhi::BufferDesc& desc);
    ~BufferObject() { glDeleteBuffers(1, &name); }
    BufferObject(const BufferObject&) = delete;
    BufferObject& operator=(const BufferObject&) = delete;

    const rhi::BufferDesc desc;
    GLuint name = 0;
};

struct SamplerObject {
    explicit SamplerObject(const rhi::SamplerDesc& desc);
    ~SamplerObject() { glDeleteSamplers(1, &name); }
    SamplerObject(const SamplerObject&) = delete;
    SamplerObject& operator=(const SamplerObject&) = delete;

    const rhi::SamplerDesc desc;
    GLuint name = 0;
};

struct PipelineObject {
    /// Compiles and links. Throws Error(internal) with the driver's words where it will not have it.
    PipelineObject(const std::string& name, const rhi::Shader& shader, std::span<const rhi::Specialization> specialization,
                   rhi::Format target_format);
    ~PipelineObject() { glDeleteProgram(program); }
    PipelineObject(const PipelineObject&) = delete;
    PipelineObject& operator=(const PipelineObject&) = delete;
    [[nodiscard]] rhi::PipelineFacts facts() const noexcept { return {name, shader, target_format}; }

    const std::string name;
    const rhi::Shader* const shader;
    const rhi::Format target_format;
    GLuint program = 0;
};

/// Keeps what it binds.
struct BindingsObject {
    struct Slot {
        const rhi::SlotDesc* desc;
        std::uint32_t unit;  ///< Of textures or images, or the binding of a block.
        std::shared_ptr<TextureObject> texture;
        std::shared_ptr<SamplerObject> sampler;
        std::shared_ptr<BufferObject> buffer;
    };
    [[nodiscard]] rhi::BindingSetFacts facts() const noexcept { return {name, shader}; }

    std::string name;
    const rhi::Shader* shader;
    std::vector<Slot> slots;
};

/// Forgets errors that the host has left, and throws Error(out_of_memory or internal), naming the object, for those that came
/// since.
class CreationErrors {
public:
    CreationErrors() noexcept {
        while (glGetError() != GL_NO_ERROR) continue;
    }
    void check(const std::string& object) const;
};

}  // namespace aureole::gl
