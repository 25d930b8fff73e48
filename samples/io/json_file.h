// JSON files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace aureole::app {

/// Throws Error: io; invalid_argument naming the file and where it is no JSON.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& path);

/// For messages: the text of a value, cut to 80 bytes; of one that holds others that hold others the kind and size alone, since
/// nlohmann::json prints by recursion, and a file may nest as deep as it is long.
[[nodiscard]] std::string show_json(const nlohmann::json& value);

}  // namespace aureole::app
