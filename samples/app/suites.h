// Where the program's own suites are.
#pragma once

#include "measure/suite.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aureole::app {

/// A file by its path, or a suite of the program's own by its name ("small"): share/aureole/suites/small.toml beside the folder
/// that the program is in. Throws Error(io) naming the suites that there are.
[[nodiscard]] std::filesystem::path find_suite(const std::string& name);

/// Names of the program's own suites, sorted.
[[nodiscard]] std::vector<std::string> own_suites();

/// Keeps these airs, in this order, and their scenes; all if there are no names. Throws Error(invalid_argument) naming --airs
/// for one that the suite does not have, or that is named twice.
void keep_airs(Suite& suite, const std::vector<std::string>& names);

}  // namespace aureole::app
