// What a run has finished, kept in files for the next.
#pragma once

#include "io/file.h"

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
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

/// What the file holds if it was kept under the same key; else what `make` makes, which is kept. A broken file counts as none.
template <class Make>
nlohmann::json kept_or(const std::filesystem::path& file, const nlohmann::json& key, const Make& make) {
    if (std::filesystem::exists(file)) {
        nlohmann::json kept = nlohmann::json::parse(read_text(file), nullptr, false);
        if (kept.is_object() && kept.value("key", nlohmann::json()) == key && kept.contains("results"))
            return std::move(kept.at("results"));
    }
    nlohmann::json results = make();
    std::filesystem::create_directories(file.parent_path());
    write_text(file, nlohmann::json{{"key", key}, {"results", results}}.dump() + "\n");
    return results;
}

}  // namespace aureole::app
