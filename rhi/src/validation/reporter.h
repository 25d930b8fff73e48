// Tells misuses to the host.
#pragma once

#include <aureole/rhi/device.h>
#include <aureole/rhi/validation.h>

#include <cstdint>
#include <string>

namespace aureole::rhi::validation {

class Reporter {
public:
    explicit Reporter(const ValidationDesc& desc) : throws_(desc.throw_on_misuse) {}

    void set_callback(MessageCallback callback, void* user) { callback_ = callback, user_ = user; }

    /// Reports, and throws Error(misuse) if the host asked for that.
    void misuse(const std::string& text) {
        tell(text);
        if (throws_) throw Error(ErrorCode::misuse, text);
    }
    /// For functions that throw in any case.
    [[noreturn]] void misuse_and_throw(const std::string& text, ErrorCode code = ErrorCode::misuse) {
        tell(text);
        throw Error(code, text);
    }
    /// Reports and never throws.
    void tell(const std::string& text) {
        ++count_;
        pass_on(Severity::error, text.c_str());
    }
    void pass_on(Severity severity, const char* text) const {
        if (callback_) callback_(user_, severity, text);
    }
    [[nodiscard]] std::uint64_t count() const { return count_; }

private:
    bool throws_;
    MessageCallback callback_ = nullptr;
    void* user_ = nullptr;
    std::uint64_t count_ = 0;
};

}  // namespace aureole::rhi::validation
