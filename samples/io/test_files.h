// For tests: files to break, and what is said about them.
#pragma once

#include <aureole/rhi/error.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace aureole::app {

/// The message of the Error that `action` throws; "nothing" if it throws none.
inline std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing";
}

inline std::filesystem::path put(const std::string& name, const std::string& contents) {
    std::ofstream(name, std::ios::binary) << contents;
    return name;
}

inline std::string get(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace aureole::app
