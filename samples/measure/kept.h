// What a run has finished, kept in files for the next.
#pragma once

#include "io/file.h"

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace aureole::app {

/// Of the program that runs: another build has another one. As it was when this was first called.
[[nodiscard]] inline const std::string& build_stamp() {
    static const std::string stamp = [] {
        const std::filesystem::path program = "/proc/self/exe";  // also where the file has been replaced meanwhile
        return std::to_string(std::filesystem::file_size(program)) + " bytes, " +
               std::to_string(std::filesystem::last_write_time(program).time_since_epoch().count());
    }();
    return stamp;
}

/// Of what has this id: letters, digits and hyphens stay.
[[nodiscard]] inline std::string file_name(std::string id) {
    for (char& c : id)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    return id + ".json";
}

/// What the file holds if it was kept under the same key. A broken file counts as none.
[[nodiscard]] inline std::optional<nlohmann::json> kept_under(const std::filesystem::path& file, const nlohmann::json& key) {
    if (!std::filesystem::exists(file)) return {};
    nlohmann::json kept = nlohmann::json::parse(read_text(file), nullptr, false);
    if (!kept.is_object() || kept.value("key", nlohmann::json()) != key || !kept.contains("results")) return {};
    return std::move(kept.at("results"));
}

/// Replaces the file.
inline void keep(const std::filesystem::path& file, const nlohmann::json& key, const nlohmann::json& results) {
    std::filesystem::create_directories(file.parent_path());
    write_text(file, nlohmann::json{{"key", key}, {"results", results}}.dump() + "\n");
}

/// The one, or what `make` makes, which is kept.
template <class Make>
nlohmann::json kept_or(const std::filesystem::path& file, const nlohmann::json& key, const Make& make) {
    if (std::optional<nlohmann::json> kept = kept_under(file, key)) return std::move(*kept);
    nlohmann::json results = make();
    keep(file, key, results);
    return results;
}

}  // namespace aureole::app
