// Where messages go: the callback of rhi::Device, filled by misuse found here and by the validation layer.
#pragma once

#include <aureole/rhi/device.h>

#include <string>

namespace aureole::vulkan {

class MessageSink {
public:
    void set(rhi::MessageCallback callback, void* user) noexcept {
        callback_ = callback;
        user_ = user;
    }
    void send(rhi::Severity severity, const char* text) const noexcept {
        if (callback_) callback_(user_, severity, text);
    }
    /// For functions that report instead of throwing.
    void misuse(const std::string& text) const noexcept { send(rhi::Severity::error, text.c_str()); }

private:
    rhi::MessageCallback callback_ = nullptr;
    void* user_ = nullptr;
};

}  // namespace aureole::vulkan
