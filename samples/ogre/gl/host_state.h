// The host's OpenGL state: whatever a recording is about to touch is read first, and all of it is put back at the end.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <bitset>
#include <cstdint>

namespace aureole::gl {

inline constexpr std::uint32_t texture_units = 32, image_units = 32,
                               block_bindings = 33;  // a slot each; push constants are last
inline constexpr std::uint32_t push_binding = block_bindings - 1;

/// Each function may be called any number of times: only the first reads. Nothing allocates.
class HostState {
public:
    void keep_program() noexcept;
    void keep_texture_unit(std::uint32_t unit) noexcept;
    void keep_image_unit(std::uint32_t unit) noexcept;
    void keep_block(std::uint32_t binding) noexcept;
    /// GL_COPY_WRITE_BUFFER, through which bytes go to buffers.
    void keep_copy_buffer() noexcept;
    /// Pixel buffers and how pixels are packed in them: set to tight packing.
    void keep_pixel_transfer() noexcept;
    /// Framebuffer, viewport and what else stands between a triangle and its texels: set so that nothing does.
    void keep_raster() noexcept;

    void restore() noexcept;

private:
    static constexpr std::array raster_switches{
        GL_DEPTH_TEST,     GL_STENCIL_TEST,     GL_CULL_FACE,      GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP,
        GL_DITHER,         GL_FRAMEBUFFER_SRGB, GL_SAMPLE_MASK,    GL_SAMPLE_COVERAGE,    GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1,   GL_CLIP_DISTANCE2, GL_CLIP_DISTANCE3,     GL_CLIP_DISTANCE4,
        GL_CLIP_DISTANCE5, GL_CLIP_DISTANCE6,   GL_CLIP_DISTANCE7, GL_SAMPLE_SHADING};
    static constexpr std::array pack_settings{
        GL_PACK_SWAP_BYTES,  GL_PACK_LSB_FIRST,     GL_PACK_ROW_LENGTH,     GL_PACK_IMAGE_HEIGHT,
        GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS,     GL_PACK_SKIP_IMAGES,    GL_UNPACK_SWAP_BYTES,
        GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH,  GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS,
        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES, GL_PACK_ALIGNMENT,      GL_UNPACK_ALIGNMENT};
    struct TextureUnit {
        GLint d2, d3, cube, array, sampler;
    };
    struct ImageUnit {
        GLint name, level, layer, access, format;
        GLboolean layered;
    };
    struct Block {
        GLint name;
        GLint64 start, size;
    };
    struct Raster {
        GLint draw_framebuffer, vertex_array, polygon_mode[2];
        GLfloat viewport[4];
        GLboolean color_mask[4];
        GLboolean blend, scissor;
        std::array<GLboolean, raster_switches.size()> switches;
    };
    void keep_texture_units() noexcept;
    void restore_textures() noexcept;
    void restore_images() noexcept;
    void restore_blocks() noexcept;
    void restore_pixel_transfer() noexcept;
    void restore_raster() noexcept;

    bool program_kept_ = false, units_kept_ = false, copy_buffer_kept_ = false, pixels_kept_ = false, raster_kept_ = false,
         blocks_kept_ = false;
    std::bitset<texture_units> texture_kept_;
    std::bitset<image_units> image_kept_;
    std::bitset<block_bindings> block_kept_;
    GLint program_ = 0, active_texture_ = 0, uniform_buffer_ = 0, copy_buffer_ = 0, pack_buffer_ = 0, unpack_buffer_ = 0;
    GLboolean seamless_ = GL_FALSE;
    std::array<TextureUnit, texture_units> textures_{};
    std::array<ImageUnit, image_units> images_{};
    std::array<Block, block_bindings> blocks_{};
    std::array<GLint, pack_settings.size()> pack_{};
    Raster raster_{};
};

}  // namespace aureole::gl
