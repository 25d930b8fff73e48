// What a run has finished, kept in files for the next.
#pragma once

#include "io/file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace aureole::app {

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
