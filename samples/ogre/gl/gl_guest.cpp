#include "gl_guest.h"

#include "command_list.h"

namespace aureole::gl {
namespace {

constexpr int needed_version = 43;

class ContextGuest final : public Guest, public rhi::Queue {
public:
    rhi::Device& device() noexcept override { return device_; }
    rhi::Queue& queue() noexcept override { return *this; }

    rhi::CommandList& begin_recording() override {
        if (recording_) throw Error(ErrorCode::misuse, "begin_recording: the recording before was not ended");
        recording_ = true;
        return list_;
    }
    void end_recording() override {
        if (!recording_) throw Error(ErrorCode::misuse, "end_recording: nothing was begun");
        recording_ = false;
        list_.finish();
    }

    rhi::CommandList& begin() override { return begin_recording(); }
    std::uint64_t submit() override {
        end_recording();
        return ++submitted_;
    }
    void wait() override { glFinish(); }

    std::uint32_t native(rhi::Texture texture) const override { return name_of(device_.object(texture), "texture"); }
    std::uint32_t native(rhi::Buffer buffer) const override { return name_of(device_.object(buffer), "buffer"); }

private:
    template <class Object>
    static GLuint name_of(const Object* object, const char* kind) {
        if (!object) throw Error(ErrorCode::invalid_argument, kind, "unknown or destroyed", "a live one of this device");
        return object->name;
    }

    Device device_;
    CommandList list_{device_};
    bool recording_ = false;
    std::uint64_t submitted_ = 0;
};

}  // namespace

std::unique_ptr<Guest> borrow_context() {
    const int version = epoxy_gl_version();
    if (!epoxy_is_desktop_gl() || version < needed_version)
        throw Error(ErrorCode::unsupported, "OpenGL context",
                    (epoxy_is_desktop_gl() ? "OpenGL " : "OpenGL ES ") + std::to_string(version / 10) + "." +
                        std::to_string(version % 10),
                    "OpenGL 4.3 or later");
    return std::make_unique<ContextGuest>();
}

}  // namespace aureole::gl
