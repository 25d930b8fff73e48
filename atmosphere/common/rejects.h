// For tests: what a call rejects.
#pragma once

#include <aureole/rhi/error.h>

#include <string>

namespace aureole::detail {

/// "<field>" of the Error(invalid_argument) that `call` throws, checked to say value and allowed range; "nothing" if it throws
/// none.
template <class Call>
std::string rejected_field(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_argument) return "wrong code: " + std::string(error.what());
        if (error.value().empty() || error.allowed().empty()) return "no value or range: " + std::string(error.what());
        const std::string message = error.what();
        for (const std::string& part : {error.field(), error.value(), error.allowed()})
            if (message.find(part) == std::string::npos) return "not in the message: " + part;
        return error.field();
    }
    return "nothing";
}

}  // namespace aureole::detail
