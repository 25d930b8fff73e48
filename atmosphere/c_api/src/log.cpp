// The library's log, to a function in C.
#include <aureole/c/base.h>
#include <aureole/rhi/log.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>

#include <memory>
#include <mutex>

#include "guard.h"

namespace {

class CallbackSink final : public spdlog::sinks::base_sink<std::mutex> {
public:
    CallbackSink(aureole_message_callback callback, void* user) : callback_(callback), user_(user) {}

private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        const aureole_severity severity = message.level >= spdlog::level::err    ? AUREOLE_ERROR
                                          : message.level >= spdlog::level::warn ? AUREOLE_WARNING
                                                                                 : AUREOLE_INFO;
        callback_(user_, severity, std::string(message.payload.data(), message.payload.size()).c_str());
    }
    void flush_() override {}

    aureole_message_callback callback_;
    void* user_;
};

}  // namespace

aureole_result aureole_set_log(aureole_message_callback callback, void* user) {
    return aureole::c_api::guarded([&] {
        if (!callback) return aureole::set_log(nullptr);
        auto sink = std::make_shared<CallbackSink>(callback, user);
        aureole::set_log(std::make_shared<spdlog::logger>("aureole", std::move(sink)));
    });
}
