#include <aureole/rhi/error.h>

namespace aureole {

const char* to_string(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::invalid_argument:
            return "invalid_argument";
        case ErrorCode::unsupported:
            return "unsupported";
        case ErrorCode::out_of_memory:
            return "out_of_memory";
        case ErrorCode::device_lost:
            return "device_lost";
        case ErrorCode::io:
            return "io";
        case ErrorCode::misuse:
            return "misuse";
        case ErrorCode::internal:
            return "internal";
    }
    return "unknown";
}

namespace {
std::string sentence(std::string_view field, std::string_view value, std::string_view allowed) {
    std::string text(field);
    text.append(": ").append(value).append(" is not allowed; allowed: ").append(allowed);
    return text;
}
}  // namespace

Error::Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

Error::Error(ErrorCode code, std::string_view field, std::string_view value, std::string_view allowed)
    : std::runtime_error(sentence(field, value, allowed)), code_(code), field_(field), value_(value), allowed_(allowed) {}

}  // namespace aureole
