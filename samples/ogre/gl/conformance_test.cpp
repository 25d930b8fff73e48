// What every rhi::Device must do, on OpenGL; and what the adapter says to a host that gives it something else than it states.
#include <aureole/rhi_tests/conformance.h>
#include <doctest/doctest.h>

#include "formats.h"
#include "gl_guest.h"
#include "test_context.h"

using namespace aureole;

namespace {

/// Textures of a host's.
class Host {
public:
    ~Host() {
        for (const GLuint name : textures_) glDeleteTextures(1, &name);
    }
    GLuint make(GLenum internal, GLsizei width, GLsizei height) {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexStorage2D(GL_TEXTURE_2D, 1, internal, width, height);
        glBindTexture(GL_TEXTURE_2D, 0);
        textures_.push_back(name);
        return name;
    }
    rhi::ExternalTexture lend(const rhi::TextureDesc& desc) {
        rhi::ExternalTexture external{desc};
        external.native = make(gl::pixel_format(desc.format).internal, static_cast<GLsizei>(desc.extent.width),
                               static_cast<GLsizei>(desc.extent.height));
        external.state = rhi::State::general;
        return external;
    }

private:
    std::vector<GLuint> textures_;
};

std::string refusal(gl::Guest& guest, const rhi::ExternalTexture& external) {
    try {
        (void)guest.device().wrap_texture(external);
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::invalid_argument);
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the OpenGL device does what every device must, and the driver's debug output is silent") {
    const auto context = gl::test::open_context();
    if (!context) return;
    for (const conformance::Check& check : conformance::checks()) {
        CAPTURE(std::string(check.name));
        Host host;
        const auto guest = gl::borrow_context();
        conformance::Target target{guest->device(), guest->queue()};
        target.lend = [&](const rhi::TextureDesc& desc) { return host.lend(desc); };
        target.pass_tolerance = 1e-4;  // as Vulkan's (docs/precision.md)
        const conformance::Result result = check.run(target);
        CAPTURE(result.text());
        CHECK(result.outcome == conformance::Outcome::passed);
        CHECK(context->take_messages() == "");
    }
}

TEST_CASE("a texture that is not what the host says is refused, by what OpenGL says of it") {
    const auto context = gl::test::open_context();
    if (!context) return;
    Host host;
    const auto guest = gl::borrow_context();
    const rhi::TextureDesc desc{"scene", rhi::Dimension::d2, rhi::Format::rgba16_float, {64, 32, 1}, rhi::Usage::sampled};
    rhi::ExternalTexture good = host.lend(desc);
    good.state = rhi::State::sampled;
    CHECK(refusal(*guest, good) == "");
    rhi::ExternalTexture bad = good;
    bad.native = 12345;
    CHECK(refusal(*guest, bad).starts_with("texture \"scene\" native: 12345 is not allowed"));
    bad = good, bad.desc.extent.height = 31;
    CHECK(refusal(*guest, bad) ==
          "texture \"scene\" extent.height: 31 is not allowed; allowed: 32, which the OpenGL texture has");
    bad = good, bad.desc.format = rhi::Format::rgba32_float;
    CHECK(refusal(*guest, bad) ==
          "texture \"scene\" format: rgba32_float is not allowed; allowed: internal format 0x881a, "
          "which the OpenGL texture has");
    bad = good, bad.desc.dimension = rhi::Dimension::d3;
    CHECK(refusal(*guest, bad).starts_with("texture \"scene\" dimension: 3d is not allowed; allowed: another"));
    (void)context->take_messages();  // of the error by which OpenGL tells a texture's dimension
}

TEST_CASE("recordings do not nest") {
    const auto context = gl::test::open_context();
    if (!context) return;
    const auto guest = gl::borrow_context();
    CHECK_THROWS_AS(guest->end_recording(), Error);
    (void)guest->begin_recording();
    CHECK_THROWS_AS((void)guest->begin_recording(), Error);
    guest->end_recording();
    CHECK_THROWS_AS((void)guest->native(rhi::Texture{77}), Error);
}
