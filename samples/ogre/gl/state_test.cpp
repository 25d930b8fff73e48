// The host's OpenGL state is the same after a recording, and after every function that makes or reads an object.
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "gl_guest.h"
#include "host_state.h"
#include "test_context.h"

using namespace aureole;

namespace {

using State = std::map<std::string, std::vector<GLint64>>;

/// A host's objects, bound everywhere that the adapter might touch, and settings that are nobody's defaults.
class UnusualHost {
public:
    UnusualHost() {
        glGenTextures(3, textures_);
        glGenBuffers(1, &buffer_);
        glGenSamplers(1, &sampler_);
        glGenFramebuffers(1, &framebuffer_);
        glGenVertexArrays(1, &vertex_array_);
        glBindBuffer(GL_UNIFORM_BUFFER, buffer_);
        glBufferData(GL_UNIFORM_BUFFER, 4096, nullptr, GL_DYNAMIC_DRAW);
        glBindTexture(GL_TEXTURE_2D, textures_[0]);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, 8, 8);
        glBindTexture(GL_TEXTURE_3D, textures_[1]);
        glTexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 4, 4, 4);
        glBindTexture(GL_TEXTURE_CUBE_MAP, textures_[2]);
        glTexStorage2D(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA8, 4, 4);
        bind();
        configure();
    }
    ~UnusualHost() {
        glDeleteTextures(3, textures_);
        glDeleteBuffers(1, &buffer_);
        glDeleteSamplers(1, &sampler_);
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteVertexArrays(1, &vertex_array_);
    }

    /// All that OpenGL tells of it.
    [[nodiscard]] static State state() {
        State all;
        for (const GLenum name : numbers) {
            GLint64 values[4] = {};
            glGetInteger64v(name, values);
            all["number " + std::to_string(name)] = {values[0], values[1], values[2], values[3]};
        }
        for (const GLenum name : switches) all["switch " + std::to_string(name)] = {glIsEnabled(name)};
        GLint active = 0;
        glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
        for (GLuint i = 0; i < 6; ++i) {
            glActiveTexture(GL_TEXTURE0 + i);
            for (const GLenum name : of_units) {
                GLint value = 0;
                glGetIntegerv(name, &value);
                all["unit " + std::to_string(i)].push_back(value);
            }
            for (const GLenum name : indexed) {
                GLint64 value = 0;
                glGetInteger64i_v(name, i, &value);
                all["index " + std::to_string(i)].push_back(value);
            }
        }
        glActiveTexture(static_cast<GLenum>(active));
        for (const GLenum name :
             std::initializer_list<GLenum>{GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE}) {
            GLint64 value = 0;
            glGetInteger64i_v(name, gl::push_binding, &value);
            all["push"].push_back(value);
        }
        return all;
    }

private:
    static constexpr GLenum numbers[] = {GL_CURRENT_PROGRAM,
                                         GL_ACTIVE_TEXTURE,
                                         GL_UNIFORM_BUFFER_BINDING,
                                         GL_COPY_WRITE_BUFFER_BINDING,
                                         GL_COPY_READ_BUFFER,
                                         GL_PIXEL_PACK_BUFFER_BINDING,
                                         GL_PIXEL_UNPACK_BUFFER_BINDING,
                                         GL_DRAW_FRAMEBUFFER_BINDING,
                                         GL_READ_FRAMEBUFFER_BINDING,
                                         GL_VERTEX_ARRAY_BINDING,
                                         GL_VIEWPORT,
                                         GL_SCISSOR_BOX,
                                         GL_COLOR_WRITEMASK,
                                         GL_POLYGON_MODE,
                                         GL_PACK_ALIGNMENT,
                                         GL_PACK_ROW_LENGTH,
                                         GL_PACK_SKIP_ROWS,
                                         GL_UNPACK_ALIGNMENT,
                                         GL_UNPACK_ROW_LENGTH,
                                         GL_UNPACK_SKIP_PIXELS,
                                         GL_UNPACK_IMAGE_HEIGHT,
                                         GL_DEPTH_WRITEMASK,
                                         GL_DEPTH_FUNC};
    static constexpr GLenum switches[] = {
        GL_BLEND,       GL_SCISSOR_TEST,   GL_DEPTH_TEST,         GL_STENCIL_TEST,
        GL_CULL_FACE,   GL_DITHER,         GL_FRAMEBUFFER_SRGB,   GL_COLOR_LOGIC_OP,
        GL_SAMPLE_MASK, GL_CLIP_DISTANCE0, GL_RASTERIZER_DISCARD, GL_TEXTURE_CUBE_MAP_SEAMLESS};
    static constexpr GLenum of_units[] = {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_CUBE_MAP,
                                          GL_TEXTURE_BINDING_2D_ARRAY, GL_SAMPLER_BINDING};
    static constexpr GLenum indexed[] = {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
                                         GL_IMAGE_BINDING_NAME,     GL_IMAGE_BINDING_LEVEL,  GL_IMAGE_BINDING_LAYER,
                                         GL_IMAGE_BINDING_ACCESS,   GL_IMAGE_BINDING_FORMAT};

    void bind() {
        for (GLuint i = 0; i < 6; ++i) {
            glActiveTexture(GL_TEXTURE0 + i);
            glBindTexture(GL_TEXTURE_2D, textures_[0]);
            glBindTexture(GL_TEXTURE_3D, textures_[1]);
            glBindTexture(GL_TEXTURE_CUBE_MAP, textures_[2]);
            glBindSampler(i, sampler_);
            glBindImageTexture(i, textures_[1], 0, GL_FALSE, 2, GL_READ_WRITE, GL_RGBA8);
            glBindBufferRange(GL_UNIFORM_BUFFER, i, buffer_, 256 * static_cast<GLintptr>(i), 512);
        }
        glBindBufferBase(GL_UNIFORM_BUFFER, gl::push_binding, buffer_);
        glActiveTexture(GL_TEXTURE5);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer_);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glBindVertexArray(vertex_array_);
    }
    static void configure() {
        for (const GLenum name :
             std::initializer_list<GLenum>{GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE,
                                           GL_COLOR_LOGIC_OP, GL_SAMPLE_MASK, GL_CLIP_DISTANCE0, GL_RASTERIZER_DISCARD})
            glEnable(name);
        glDisable(GL_DITHER);
        glViewport(3, 5, 7, 11);
        glScissor(1, 1, 2, 2);
        glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glPixelStorei(GL_PACK_ROW_LENGTH, 17);
        glPixelStorei(GL_PACK_SKIP_ROWS, 2);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 19);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
        glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 23);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_GREATER);
    }

    GLuint textures_[3] = {}, buffer_ = 0, sampler_ = 0, framebuffer_ = 0, vertex_array_ = 0;
};

std::string differences(const State& before, const State& after) {
    std::string text;
    for (const auto& [name, values] : before)
        if (after.at(name) != values) text += name + "\n";
    return text;
}

}  // namespace

TEST_CASE("a host in an unusual state gets right results, and finds its state as it left it") {
    const auto context = gl::test::open_context();
    if (!context) return;
    const UnusualHost host;
    const State before = UnusualHost::state();
    const auto guest = gl::borrow_context();
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(std::string(check.name));
        const conformance::Result result = check.run({guest->device(), guest->queue(), false});
        CAPTURE(result.text());
        CHECK(result.outcome != conformance::Outcome::failed);
        CHECK(differences(before, UnusualHost::state()) == "");
        CHECK(context->take_messages() == "");
    }
}
