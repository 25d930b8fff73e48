#include "app/suites.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <vector>

namespace aureole::app {
namespace {

std::filesystem::path own_folder() {
    std::error_code problem;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", problem);
    return program.parent_path().parent_path() / "share" / "aureole" / "suites";
}

}  // namespace

std::filesystem::path find_suite(const std::string& name) {
    if (name.ends_with(".toml") || name.find('/') != std::string::npos) return name;
    const std::filesystem::path folder = own_folder();
    const std::filesystem::path file = folder / (name + ".toml");
    if (std::filesystem::exists(file)) return std::filesystem::canonical(file);
    std::vector<std::string> names;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    std::string known;
    for (const std::string& one : names) known.append(one).append(", ");
    throw Error(ErrorCode::io, "--suite", "\"" + name + "\"",
                known + "or a file (.toml); suites are looked for in " + folder.string());
}

}  // namespace aureole::app
