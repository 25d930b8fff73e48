#include "objects.h"

#include "formats.h"
#include "host_state.h"

#include <aureole/rhi/plain_glsl.h>

#include <cstdio>

namespace aureole::gl {

void CreationErrors::check(const std::string& object) const {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) throw Error(ErrorCode::out_of_memory, object + ": not enough memory");
    char number[16];
    std::snprintf(number, sizeof number, "0x%04x", error);
    throw Error(ErrorCode::internal, object + ": OpenGL error " + number);
}

namespace {

GLsizei size(std::uint32_t texels) { return static_cast<GLsizei>(texels); }

/// Immutable storage of one level, which is complete without mips and may be viewed.
void allocate(const rhi::TextureDesc& desc, GLenum target) {
    const GLenum internal = pixel_format(desc.format).internal;
    const rhi::Extent& e = desc.extent;
    if (target == GL_TEXTURE_3D)
        glTexStorage3D(target, 1, internal, size(e.width), size(e.height), size(e.depth));
    else
        glTexStorage2D(target, 1, internal, size(e.width), size(e.height));
}

void check_name(const rhi::ExternalTexture& external) {
    if (external.native == 0 || external.native > 0xffffffffu || !glIsTexture(static_cast<GLuint>(external.native)))
        throw Error(ErrorCode::invalid_argument, rhi::field_name("texture", external.desc.name, "native"),
                    std::to_string(external.native), "the name of an OpenGL texture that has been bound once");
}

[[noreturn]] void refuse(const rhi::TextureDesc& desc, const char* field, const std::string& stated, const std::string& is) {
    throw Error(ErrorCode::invalid_argument, rhi::field_name("texture", desc.name, field), stated,
                is + ", which the OpenGL texture has");
}

GLint parameter(GLenum target, GLenum asked) {
    GLint is = 0;
    glGetTexLevelParameteriv(target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target, 0, asked, &is);
    return is;
}

void check_side(const rhi::TextureDesc& desc, GLenum target, GLenum asked, const char* field, std::uint32_t stated) {
    const GLint is = parameter(target, asked);
    if (static_cast<std::uint32_t>(is) != stated) refuse(desc, field, std::to_string(stated), std::to_string(is));
}

/// What the host says of its texture, and what OpenGL does. The texture is bound to its target, unless that is another one's.
void check_bound(const rhi::TextureDesc& desc, GLenum target) {
    if (glGetError() != GL_NO_ERROR) refuse(desc, "dimension", to_string(desc.dimension), "another");
    check_side(desc, target, GL_TEXTURE_WIDTH, "extent.width", desc.extent.width);
    check_side(desc, target, GL_TEXTURE_HEIGHT, "extent.height", desc.extent.height);
    if (target == GL_TEXTURE_3D) check_side(desc, target, GL_TEXTURE_DEPTH, "extent.depth", desc.extent.depth);
    const GLint format = parameter(target, GL_TEXTURE_INTERNAL_FORMAT);
    if (static_cast<GLenum>(format) == pixel_format(desc.format).internal) return;
    char number[16];
    std::snprintf(number, sizeof number, "0x%04x", static_cast<unsigned>(format));
    refuse(desc, "format", to_string(desc.format), std::string("internal format ") + number);
}

void check_stated(const rhi::TextureDesc& desc, GLenum target, GLuint name) {
    HostState kept;
    kept.keep_texture_unit(0);
    const CreationErrors errors;
    glBindTexture(target, name);
    try {
        check_bound(desc, target);
    } catch (...) {
        kept.restore();
        throw;
    }
    kept.restore();
}

}  // namespace

TextureObject::TextureObject(const rhi::TextureDesc& d) : desc(d), target(texture_target(d.dimension)), owned_(true) {
    const CreationErrors errors;
    HostState kept;
    kept.keep_texture_unit(0);
    glGenTextures(1, &name);
    glBindTexture(target, name);
    allocate(desc, target);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    kept.restore();
    try {
        errors.check(rhi::field_name("texture", desc.name, ""));
        make_uses();
    } catch (...) {
        release();
        throw;
    }
}

TextureObject::TextureObject(const rhi::ExternalTexture& external)
    : desc(external.desc),
      target(texture_target(external.desc.dimension)),
      name(static_cast<GLuint>(external.native)),
      owned_(false) {
    check_name(external);
    check_stated(desc, target, name);
    try {
        make_uses();
    } catch (...) {
        release();
        throw;
    }
}

TextureObject::~TextureObject() { release(); }

/// What a use needs beside the texture itself.
void TextureObject::make_uses() {
    const CreationErrors errors;
    image = name;
    if (rhi::has(desc.usage, rhi::Usage::storage) && target == GL_TEXTURE_CUBE_MAP) {
        glGenTextures(1, &image);
        glTextureView(image, GL_TEXTURE_2D_ARRAY, name, pixel_format(desc.format).internal, 0, 1, 0, 6);
    }
    if (rhi::has(desc.usage, rhi::Usage::color_attachment)) {
        HostState kept;
        kept.keep_raster();
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        glFramebufferTexture(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, name, 0);
        const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
        kept.restore();
        if (status != GL_FRAMEBUFFER_COMPLETE)
            throw Error(ErrorCode::unsupported, rhi::field_name("texture", desc.name, "usage"), "color_attachment",
                        "textures that this context draws to");
    }
    errors.check(rhi::field_name("texture", desc.name, ""));
}

void TextureObject::release() noexcept {
    glDeleteFramebuffers(1, &framebuffer);
    if (image != name) glDeleteTextures(1, &image);
    if (owned_) glDeleteTextures(1, &name);
}

BufferObject::BufferObject(const rhi::BufferDesc& d) : desc(d) {
    const CreationErrors errors;
    HostState kept;
    kept.keep_copy_buffer();
    const GLenum use = rhi::has(desc.usage, rhi::Usage::read_back) ? GL_DYNAMIC_READ
                       : rhi::has(desc.usage, rhi::Usage::upload)  ? GL_STREAM_DRAW
                                                                   : GL_DYNAMIC_DRAW;
    glGenBuffers(1, &name);
    glBindBuffer(GL_COPY_WRITE_BUFFER, name);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(desc.size), nullptr, use);
    kept.restore();
    try {
        errors.check(rhi::field_name("buffer", desc.name, ""));
    } catch (...) {
        glDeleteBuffers(1, &name);
        throw;
    }
}

SamplerObject::SamplerObject(const rhi::SamplerDesc& d) : desc(d) {
    const auto wrap = [](rhi::Address address) { return address == rhi::Address::clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT; };
    const GLint filter = desc.filter == rhi::Filter::linear ? GL_LINEAR : GL_NEAREST;  // neither reads mips
    glGenSamplers(1, &name);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap(desc.address_u));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap(desc.address_v));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_R, wrap(desc.address_w));
}

namespace {

constexpr const char* triangle = R"(#version 430
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";

std::string log_of(GLuint object, bool program) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    const auto room = static_cast<GLsizei>(log.size());
    if (program)
        glGetProgramInfoLog(object, room, &length, log.data());
    else
        glGetShaderInfoLog(object, room, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

void attach(GLuint program, GLenum stage, const std::string& text, const std::string& pipeline) {
    const GLuint shader = glCreateShader(stage);
    const char* pointer = text.c_str();
    glShaderSource(shader, 1, &pointer, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    const std::string log = compiled ? "" : log_of(shader, false);
    if (compiled) glAttachShader(program, shader);
    glDeleteShader(shader);  // lives as long as it is attached
    if (!compiled)
        throw Error(ErrorCode::internal, rhi::field_name("pipeline", pipeline, "") + ": OpenGL does not compile it: " + log);
}

void link(GLuint program, const std::string& pipeline) {
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
        throw Error(ErrorCode::internal,
                    rhi::field_name("pipeline", pipeline, "") + ": OpenGL does not link it: " + log_of(program, true));
}

}  // namespace

PipelineObject::PipelineObject(const std::string& n, const rhi::Shader& s, std::span<const rhi::Specialization> specialization,
                               rhi::Format format)
    : name(n), shader(&s), target_format(format), program(glCreateProgram()) {
    const std::string text = rhi::plain_glsl(s, specialization, {.version = 430, .push_binding = push_binding});
    const bool compute = s.stage == rhi::Stage::compute;
    try {
        attach(program, compute ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER, text, name);
        if (!compute) attach(program, GL_VERTEX_SHADER, triangle, name);
        link(program, name);
    } catch (...) {
        glDeleteProgram(program);
        throw;
    }
}

}  // namespace aureole::gl
