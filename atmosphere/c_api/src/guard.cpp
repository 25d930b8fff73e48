#include "guard.h"

#include <aureole/c/adapter.h>

#include <exception>
#include <new>
#include <utility>

namespace aureole::c_api {
namespace {

struct LastError {
    std::string message, field, value, allowed;
};
thread_local LastError last_error;
thread_local std::string callback_error;

void keep(LastError error) noexcept { last_error = std::move(error); }

}  // namespace

aureole_result result_of(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::invalid_argument:
            return AUREOLE_INVALID_ARGUMENT;
        case ErrorCode::unsupported:
            return AUREOLE_UNSUPPORTED;
        case ErrorCode::out_of_memory:
            return AUREOLE_OUT_OF_MEMORY;
        case ErrorCode::device_lost:
            return AUREOLE_DEVICE_LOST;
        case ErrorCode::io:
            return AUREOLE_IO;
        case ErrorCode::misuse:
            return AUREOLE_MISUSE;
        case ErrorCode::internal:
            return AUREOLE_INTERNAL;
    }
    return AUREOLE_INTERNAL;
}

ErrorCode code_of(aureole_result result) noexcept {
    for (const ErrorCode code : {ErrorCode::invalid_argument, ErrorCode::unsupported, ErrorCode::out_of_memory,
                                 ErrorCode::device_lost, ErrorCode::io, ErrorCode::misuse})
        if (result_of(code) == result) return code;
    return ErrorCode::internal;
}

aureole_result caught() noexcept {
    try {
        try {
            throw;
        } catch (const Error& error) {
            keep({error.what(), error.field(), error.value(), error.allowed()});
            return result_of(error.code());
        } catch (const std::bad_alloc&) {
            keep({"out of memory", {}, {}, {}});
            return AUREOLE_OUT_OF_MEMORY;
        } catch (const std::exception& error) {
            keep({error.what(), {}, {}, {}});
        } catch (...) {
            keep({"something unknown was thrown", {}, {}, {}});
        }
    } catch (...) {
        keep({});  // no memory even for the message
        return AUREOLE_OUT_OF_MEMORY;
    }
    return AUREOLE_INTERNAL;
}

std::string take_callback_error() { return std::exchange(callback_error, {}); }

}  // namespace aureole::c_api

using namespace aureole;

const char* aureole_result_name(aureole_result result) {
    if (result == AUREOLE_OK) return "ok";
    if (result < AUREOLE_OK || result > AUREOLE_INTERNAL) return "unknown";
    return to_string(c_api::code_of(result));
}

const char* aureole_last_error(void) { return c_api::last_error.message.c_str(); }
const char* aureole_last_error_field(void) { return c_api::last_error.field.c_str(); }
const char* aureole_last_error_value(void) { return c_api::last_error.value.c_str(); }
const char* aureole_last_error_allowed(void) { return c_api::last_error.allowed.c_str(); }
const char* aureole_version(void) { return AUREOLE_VERSION; }

void aureole_set_callback_error(const char* text) {
    try {
        c_api::callback_error = text ? text : "";
    } catch (...) {
        c_api::callback_error.clear();
    }
}
