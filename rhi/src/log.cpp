#include <aureole/rhi/log.h>

#include <spdlog/logger.h>
#include <atomic>

namespace aureole {
namespace {

std::shared_ptr<spdlog::logger> silent() {
    static const auto logger = std::make_shared<spdlog::logger>("aureole");  // no sinks
    return logger;
}
std::atomic<std::shared_ptr<spdlog::logger>>& current() {
    static std::atomic<std::shared_ptr<spdlog::logger>> logger{silent()};
    return logger;
}

}  // namespace

std::shared_ptr<spdlog::logger> log() { return current().load(); }
void set_log(std::shared_ptr<spdlog::logger> logger) { current().store(logger ? std::move(logger) : silent()); }

}  // namespace aureole
