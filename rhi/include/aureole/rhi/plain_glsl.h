// A shader as plain GLSL, for hosts whose device compiles text: version 4.30 and later, without descriptor sets, specialization
// constants and push constants, and with few image units. (Which devices these are: docs/other-apis.md.)
#pragma once

#include <aureole/rhi/shader.h>

#include <cstdint>
#include <span>
#include <string>

namespace aureole::rhi {

/// What plain_glsl makes its text for.
struct PlainGlslOptions {
    std::uint32_t version = 430;  ///< Of `#version`: 430 or more, and no more than the compiler knows.
    /// Of the uniform block that stands for push constants. 32 or more (slots end at 31), below the device's number of them.
    std::uint32_t push_binding = 32;
};

/// `shader.glsl` for that version. Specialization constants are plain constants with the given values, or their defaults; ids
/// that the shader does not have are ignored, as in pipelines. A sampled texture's slot is its texture unit, a uniform block's
/// slot its binding, an image's unit is plain_glsl_image_unit, and push constants are a std140 block. Rows and coordinates are
/// those of the textures' own memory: nothing is to be flipped. Throws Error(invalid_argument) for options out of range.
[[nodiscard]] std::string plain_glsl(const Shader& shader, std::span<const Specialization> specialization,
                                     const PlainGlslOptions& options = {});

/// Image unit of a storage texture: numbered from 0 by rising slots, for a device need have no more than 8 units.
[[nodiscard]] std::uint32_t plain_glsl_image_unit(const Shader& shader, std::uint32_t slot) noexcept;

}  // namespace aureole::rhi
