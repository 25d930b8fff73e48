// Where Aureole logs: one spdlog logger named "aureole", silent until a program gives it somewhere to write.
#pragma once

#include <memory>

namespace spdlog {
class logger;
}

namespace aureole {

/// The logger in use; never null. By default it has no sink. Safe from any thread.
[[nodiscard]] std::shared_ptr<spdlog::logger> log();
/// Replaces it; null brings the silent one back.
void set_log(std::shared_ptr<spdlog::logger> logger);

}  // namespace aureole
