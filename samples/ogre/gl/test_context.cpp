#include "test_context.h"

#include <doctest/doctest.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <utility>

namespace aureole::gl::test {
namespace {

class SurfacelessContext final : public TestContext {
public:
    SurfacelessContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(listen, this);
    }
    ~SurfacelessContext() override {
        CHECK(take_messages() == "");
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    std::string take_messages() override { return std::exchange(messages_, {}); }

private:
    static void GLAPIENTRY listen(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* self) {
        if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
            static_cast<SurfacelessContext*>(const_cast<void*>(self))->messages_ += std::string(text) + "\n";
    }

    EGLDisplay display_;
    EGLContext context_;
    std::string messages_;
};

}  // namespace

std::unique_ptr<TestContext> open_context() {
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    constexpr EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE};
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) && eglBindAPI(EGL_OPENGL_API)) {
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            return std::make_unique<SurfacelessContext>(display, context);
    }
    MESSAGE("skipped: no usable OpenGL context");
    return nullptr;
}

}  // namespace aureole::gl::test
