// A shader as an OpenGL context of version 4.3 or later takes it, for hosts whose device stands on one: they compile GLSL, know
// neither specialization nor push constants, and have few image units.
#pragma once

#include <aureole/rhi/shader.h>

#include <cstdint>
#include <span>
#include <string>

namespace aureole::rhi {

/// What opengl_text makes its text for.
struct OpenGlTextOptions {
    std::uint32_t version = 430;  ///< Of `#version`: 430 or more, and no more than the context's.
    /// Of the uniform block that stands for push constants. 32 or more (slots end at 31), below GL_MAX_UNIFORM_BUFFER_BINDINGS.
    std::uint32_t push_binding = 32;
};

/// `shader.glsl` for that version. Specialization constants are plain constants with the given values, or their defaults; ids
/// that the shader does not have are ignored, as by Vulkan. A sampled texture's slot is its texture unit, a uniform block's
/// slot its binding, an image's unit is opengl_image_unit, and push constants are a std140 block. Rows and coordinates are
/// those of the textures' own memory: nothing is to be flipped. Throws Error(invalid_argument) for options out of range.
[[nodiscard]] std::string opengl_text(const Shader& shader, std::span<const Specialization> specialization,
                                      const OpenGlTextOptions& options = {});

/// Image unit of a storage texture: numbered from 0 by rising slots, for a context need have no more than 8 units.
[[nodiscard]] std::uint32_t opengl_image_unit(const Shader& shader, std::uint32_t slot) noexcept;

}  // namespace aureole::rhi
