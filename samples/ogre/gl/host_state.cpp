#include "host_state.h"

namespace aureole::gl {
namespace {

GLint integer(GLenum name) noexcept {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLint integer(GLenum name, std::uint32_t index) noexcept {
    GLint value = 0;
    glGetIntegeri_v(name, index, &value);
    return value;
}

void set(GLenum capability, GLboolean on) noexcept {
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

void set(GLenum capability, GLuint index, GLboolean on) noexcept {
    if (on)
        glEnablei(capability, index);
    else
        glDisablei(capability, index);
}

GLuint name(GLint queried) noexcept { return static_cast<GLuint>(queried); }

}  // namespace

void HostState::keep_program() noexcept {
    if (program_kept_) return;
    program_kept_ = true;
    program_ = integer(GL_CURRENT_PROGRAM);
}

void HostState::keep_texture_units() noexcept {
    if (units_kept_) return;
    units_kept_ = true;
    active_texture_ = integer(GL_ACTIVE_TEXTURE);
    seamless_ = glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // filters cross the faces' edges
}

void HostState::keep_texture_unit(std::uint32_t unit) noexcept {
    keep_texture_units();
    if (texture_kept_.test(unit)) return;
    texture_kept_.set(unit);
    glActiveTexture(GL_TEXTURE0 + unit);
    textures_[unit] = {integer(GL_TEXTURE_BINDING_2D), integer(GL_TEXTURE_BINDING_3D), integer(GL_TEXTURE_BINDING_CUBE_MAP),
                       integer(GL_TEXTURE_BINDING_2D_ARRAY), integer(GL_SAMPLER_BINDING)};
}

void HostState::keep_image_unit(std::uint32_t unit) noexcept {
    if (image_kept_.test(unit)) return;
    image_kept_.set(unit);
    ImageUnit& image = images_[unit];
    image = {integer(GL_IMAGE_BINDING_NAME, unit),   integer(GL_IMAGE_BINDING_LEVEL, unit),
             integer(GL_IMAGE_BINDING_LAYER, unit),  integer(GL_IMAGE_BINDING_ACCESS, unit),
             integer(GL_IMAGE_BINDING_FORMAT, unit), GL_FALSE};
    glGetBooleani_v(GL_IMAGE_BINDING_LAYERED, unit, &image.layered);
}

void HostState::keep_block(std::uint32_t binding) noexcept {
    if (!blocks_kept_) uniform_buffer_ = integer(GL_UNIFORM_BUFFER_BINDING);
    blocks_kept_ = true;
    if (block_kept_.test(binding)) return;
    block_kept_.set(binding);
    Block& block = blocks_[binding];
    block.name = integer(GL_UNIFORM_BUFFER_BINDING, binding);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, binding, &block.start);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, binding, &block.size);
}

void HostState::keep_copy_buffer() noexcept {
    if (copy_buffer_kept_) return;
    copy_buffer_kept_ = true;
    copy_buffer_ = integer(GL_COPY_WRITE_BUFFER_BINDING);
}

void HostState::keep_pixel_transfer() noexcept {
    if (pixels_kept_) return;
    pixels_kept_ = true;
    pack_buffer_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    unpack_buffer_ = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    for (std::size_t i = 0; i < pack_settings.size(); ++i) {
        const GLenum setting = static_cast<GLenum>(pack_settings[i]);
        pack_[i] = integer(setting);
        glPixelStorei(setting, setting == GL_PACK_ALIGNMENT || setting == GL_UNPACK_ALIGNMENT ? 1 : 0);
    }
}

void HostState::keep_raster() noexcept {
    if (raster_kept_) return;
    raster_kept_ = true;
    Raster& r = raster_;
    r.draw_framebuffer = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    r.vertex_array = integer(GL_VERTEX_ARRAY_BINDING);
    glGetIntegerv(GL_POLYGON_MODE, r.polygon_mode);
    glGetFloati_v(GL_VIEWPORT, 0, r.viewport);
    glGetBooleani_v(GL_COLOR_WRITEMASK, 0, r.color_mask);
    r.blend = glIsEnabledi(GL_BLEND, 0);
    r.scissor = glIsEnabledi(GL_SCISSOR_TEST, 0);
    for (std::size_t i = 0; i < raster_switches.size(); ++i) {
        const GLenum capability = static_cast<GLenum>(raster_switches[i]);
        r.switches[i] = glIsEnabled(capability);
        glDisable(capability);
    }
    glEnable(GL_FRAMEBUFFER_SRGB);  // of no effect on other formats
    glDisablei(GL_BLEND, 0);
    glDisablei(GL_SCISSOR_TEST, 0);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void HostState::restore_textures() noexcept {
    for (std::uint32_t unit = 0; unit < texture_units; ++unit) {
        if (!texture_kept_.test(unit)) continue;
        const TextureUnit& kept = textures_[unit];
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, name(kept.d2));
        glBindTexture(GL_TEXTURE_3D, name(kept.d3));
        glBindTexture(GL_TEXTURE_CUBE_MAP, name(kept.cube));
        glBindTexture(GL_TEXTURE_2D_ARRAY, name(kept.array));
        glBindSampler(unit, name(kept.sampler));
    }
    glActiveTexture(static_cast<GLenum>(active_texture_));
    set(GL_TEXTURE_CUBE_MAP_SEAMLESS, seamless_);
}

void HostState::restore_images() noexcept {
    for (std::uint32_t unit = 0; unit < image_units; ++unit) {
        if (!image_kept_.test(unit)) continue;
        const ImageUnit& kept = images_[unit];
        glBindImageTexture(unit, name(kept.name), kept.level, kept.layered, kept.layer, static_cast<GLenum>(kept.access),
                           static_cast<GLenum>(kept.format));
    }
}

void HostState::restore_blocks() noexcept {
    for (std::uint32_t binding = 0; binding < block_bindings; ++binding) {
        if (!block_kept_.test(binding)) continue;
        const Block& kept = blocks_[binding];
        if (kept.size > 0)  // 0: the whole buffer, or none
            glBindBufferRange(GL_UNIFORM_BUFFER, binding, name(kept.name), kept.start, kept.size);
        else
            glBindBufferBase(GL_UNIFORM_BUFFER, binding, name(kept.name));
    }
    glBindBuffer(GL_UNIFORM_BUFFER, name(uniform_buffer_));
}

void HostState::restore_pixel_transfer() noexcept {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name(pack_buffer_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, name(unpack_buffer_));
    for (std::size_t i = 0; i < pack_settings.size(); ++i) glPixelStorei(static_cast<GLenum>(pack_settings[i]), pack_[i]);
}

void HostState::restore_raster() noexcept {
    const Raster& r = raster_;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name(r.draw_framebuffer));
    glBindVertexArray(name(r.vertex_array));
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(r.polygon_mode[0]));
    glViewportIndexedfv(0, r.viewport);
    glColorMaski(0, r.color_mask[0], r.color_mask[1], r.color_mask[2], r.color_mask[3]);
    set(GL_BLEND, 0, r.blend);
    set(GL_SCISSOR_TEST, 0, r.scissor);
    for (std::size_t i = 0; i < raster_switches.size(); ++i) set(static_cast<GLenum>(raster_switches[i]), r.switches[i]);
}

void HostState::restore() noexcept {
    if (program_kept_) glUseProgram(name(program_));
    if (units_kept_) restore_textures();
    restore_images();
    if (blocks_kept_) restore_blocks();
    if (copy_buffer_kept_) glBindBuffer(GL_COPY_WRITE_BUFFER, name(copy_buffer_));
    if (pixels_kept_) restore_pixel_transfer();
    if (raster_kept_) restore_raster();
    program_kept_ = units_kept_ = copy_buffer_kept_ = pixels_kept_ = raster_kept_ = blocks_kept_ = false;
    texture_kept_.reset();
    image_kept_.reset();
    block_kept_.reset();
}

}  // namespace aureole::gl
