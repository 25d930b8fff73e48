#include "formats.h"

namespace aureole::gl {

using rhi::Dimension;
using rhi::Format;
using rhi::State;

PixelFormat pixel_format(Format format) noexcept {
    switch (format) {
        case Format::r8_unorm:
            return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
        case Format::rgba8_unorm:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::rgba8_srgb:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::bgra8_unorm:  // an order of bytes in buffers alone
            return {GL_RGBA8, GL_BGRA, GL_UNSIGNED_BYTE};
        case Format::r16_float:
            return {GL_R16F, GL_RED, GL_HALF_FLOAT};
        case Format::rg16_float:
            return {GL_RG16F, GL_RG, GL_HALF_FLOAT};
        case Format::rgba16_float:
            return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
        case Format::r32_float:
            return {GL_R32F, GL_RED, GL_FLOAT};
        case Format::rg32_float:
            return {GL_RG32F, GL_RG, GL_FLOAT};
        case Format::rgba32_float:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case Format::r11g11b10_float:
            return {GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV};
        case Format::d32_float:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
        case Format::undefined:
            break;
    }
    return {GL_NONE, GL_NONE, GL_NONE};
}

rhi::FormatSupport format_support(Format format, Dimension dimension) noexcept {
    rhi::FormatSupport support;
    if (rhi::bytes_per_texel(format) == 0 || dimension > Dimension::cube) return support;
    const bool depth = format == Format::d32_float;
    support.sampled = support.linear_filter = !depth || dimension == Dimension::d2;
    support.storage = !depth && format != Format::rgba8_srgb;
    support.color_attachment = !depth && dimension == Dimension::d2;
    return support;
}

GLenum texture_target(Dimension dimension) noexcept {
    if (dimension == Dimension::d3) return GL_TEXTURE_3D;
    return dimension == Dimension::cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
}

GLenum binding_query(GLenum target) noexcept {
    switch (target) {
        case GL_TEXTURE_3D:
            return GL_TEXTURE_BINDING_3D;
        case GL_TEXTURE_CUBE_MAP:
            return GL_TEXTURE_BINDING_CUBE_MAP;
        case GL_TEXTURE_2D_ARRAY:
            return GL_TEXTURE_BINDING_2D_ARRAY;
        default:
            return GL_TEXTURE_BINDING_2D;
    }
}

namespace {

GLbitfield bits_of_use(State state) noexcept {
    switch (state) {
        case State::sampled:
        case State::depth_read:
            return GL_TEXTURE_FETCH_BARRIER_BIT;
        case State::storage_write:
            return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
        case State::color_attachment:
            return GL_FRAMEBUFFER_BARRIER_BIT;
        case State::copy_source:
        case State::copy_destination:
            return GL_TEXTURE_UPDATE_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT;
        case State::constants:
            return GL_UNIFORM_BARRIER_BIT;
        case State::undefined:
        case State::general:
            break;
    }
    return GL_ALL_BARRIER_BITS;
}

}  // namespace

GLbitfield barrier_bits(State before, State after) noexcept {
    // Stores to images are the one kind of write that OpenGL does not order. In `undefined` a texture may have been stored to
    // by a recording that was invalidated, in `general` by the host.
    const bool stored = before == State::storage_write || before == State::undefined || before == State::general;
    if (stored) return bits_of_use(after);
    // Nor does it order a store after the reads before it.
    return after == State::storage_write ? GL_SHADER_IMAGE_ACCESS_BARRIER_BIT : 0;
}

}  // namespace aureole::gl
