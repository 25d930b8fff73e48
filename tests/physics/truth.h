// Tables of truth from solvers that share nothing with the library: tests/truth, or the folder that the environment variable
// AUREOLE_TRUTH_DIR names.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace aureole::physics {

/// Rows of a comma-separated table by column name, as text; comment lines joined.
struct TruthTable {
    std::string comment;
    std::vector<std::map<std::string, std::string>> rows;
};
/// Where the table of that file name is.
[[nodiscard]] std::filesystem::path truth_file(const std::string& name);
/// The table of that file name. Throws std::runtime_error naming the file if it is not there, has a row of the wrong length, or
/// none at all.
[[nodiscard]] TruthTable read_truth(const std::string& name);
[[nodiscard]] double number(const std::map<std::string, std::string>& row, const std::string& column);

}  // namespace aureole::physics
