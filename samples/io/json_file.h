// JSON files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace aureole::app {

/// Throws Error: io; invalid_argument naming the file and where it is no JSON.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& path);

}  // namespace aureole::app
