// Tables of truth from solvers that share nothing with the library. They are not part of the tree: the environment variable
// AUREOLE_TRUTH_DIR names their folder; without it, shared/truth beside the tree is looked for.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aureole::physics {

/// The file, or nothing if it cannot be found; then it says so on standard output, once for each file.
[[nodiscard]] std::optional<std::filesystem::path> truth_file(const std::string& name);

/// Rows of a comma-separated table by column name, as text; comment lines joined.
struct TruthTable {
    std::string comment;
    std::vector<std::map<std::string, std::string>> rows;
};
[[nodiscard]] TruthTable read_truth(const std::filesystem::path& path);
[[nodiscard]] double number(const std::map<std::string, std::string>& row, const std::string& column);

}  // namespace aureole::physics
