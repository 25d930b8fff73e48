// What the interface's words are in OpenGL's.
#pragma once

#include <aureole/rhi/device.h>
#include <epoxy/gl.h>

namespace aureole::gl {

struct PixelFormat {
    GLenum internal;      ///< Of the texture, and of an image unit that writes it.
    GLenum layout, type;  ///< Of texels in buffers.
};
/// Any format but `undefined`.
[[nodiscard]] PixelFormat pixel_format(rhi::Format format) noexcept;
/// OpenGL promises these uses of every format (core profile 4.3, tables 8.12, 8.13 and 8.26): nothing is to be asked.
[[nodiscard]] rhi::FormatSupport format_support(rhi::Format format, rhi::Dimension dimension) noexcept;

[[nodiscard]] GLenum texture_target(rhi::Dimension dimension) noexcept;
/// GL_TEXTURE_BINDING_*: what asks for the texture that is bound.
[[nodiscard]] GLenum binding_query(GLenum texture_target) noexcept;

/// Bits of glMemoryBarrier for one resource that moves from a state to another; 0 if OpenGL orders the two by itself.
[[nodiscard]] GLbitfield barrier_bits(rhi::State before, rhi::State after) noexcept;

}  // namespace aureole::gl
