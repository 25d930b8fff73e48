// Where the program's own suites are.
#pragma once

#include <filesystem>
#include <string>

namespace aureole::app {

/// A file by its path, or a suite of the program's own by its name ("small"): share/aureole/suites/small.toml beside the folder
/// that the program is in. Throws Error(io) naming the suites that there are.
[[nodiscard]] std::filesystem::path find_suite(const std::string& name);

}  // namespace aureole::app
