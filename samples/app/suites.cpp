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

std::vector<std::string> own_suites() {
    const std::filesystem::path folder = own_folder();
    std::vector<std::string> names;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

std::filesystem::path find_suite(const std::string& name) {
    if (name.ends_with(".toml") || name.find('/') != std::string::npos) return name;
    const std::filesystem::path folder = own_folder();
    const std::filesystem::path file = folder / (name + ".toml");
    if (std::filesystem::exists(file)) return std::filesystem::canonical(file);
    std::string known;
    for (const std::string& one : own_suites()) known.append(one).append(", ");
    throw Error(ErrorCode::io, "--suite", "\"" + name + "\"",
                known + "or a file (.toml); suites are looked for in " + folder.string());
}

void keep_airs(Suite& suite, const std::vector<std::string>& names) {
    if (names.empty()) return;
    const Suite whole = suite;
    suite.airs.clear();
    suite.scenes.clear();
    for (const std::string& name : names) {
        const auto air = std::ranges::find(whole.airs, name, &SuiteAir::name);
        if (air == whole.airs.end() || std::ranges::find(suite.airs, name, &SuiteAir::name) != suite.airs.end())
            throw Error(ErrorCode::invalid_argument, "--airs", name, "airs of the suite, each once");
        suite.airs.push_back(*air);
        for (const std::size_t i : whole.scenes_of(static_cast<std::size_t>(air - whole.airs.begin()))) {
            suite.scenes.push_back(whole.scenes[i]);
            suite.scenes.back().air = suite.airs.size() - 1;
        }
    }
}

}  // namespace aureole::app
