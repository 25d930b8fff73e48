// Strict reading of TOML: a section knows which of its keys have been asked for and rejects all others, and every message says
// file, line, key, value and what is allowed.
#pragma once

#include <aureole/parameters.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// Allowed values of a number, both ends included.
struct Range {
    double low, high;
};

class TomlDocument;

/// One table of a document: `[camera]`, one of several `[[sun]]`, or an inline `{ ... }`.
class Section {
public:
    [[nodiscard]] bool has(std::string_view key) const;

    // A missing key gives nothing; a present one of the wrong type or outside its range throws Error(invalid_argument).
    [[nodiscard]] std::optional<double> number(std::string_view key, Range range);
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key, Range range);
    /// A number for all three, or an array of three.
    [[nodiscard]] std::optional<Rgb> rgb(std::string_view key, Range range);
    [[nodiscard]] std::optional<bool> boolean(std::string_view key);
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    /// A text, or an array of texts.
    [[nodiscard]] std::optional<std::vector<std::string>> texts(std::string_view key);
    /// Index of the choice.
    [[nodiscard]] std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> choices);
    [[nodiscard]] std::optional<std::size_t> choice(std::string_view key, std::initializer_list<std::string_view> choices) {
        return choice(key, std::span(choices.begin(), choices.size()));
    }
    [[nodiscard]] std::optional<Section> section(std::string_view key);
    [[nodiscard]] std::vector<Section> sections(std::string_view key);

    /// True if the key holds a text (for keys that take a text or a number).
    [[nodiscard]] bool is_text(std::string_view key) const;

    /// The key's value as a message shows it; long arrays by their length alone.
    [[nodiscard]] std::string printed(std::string_view key) const;

    /// Throws if a key has not been asked for, naming the keys that can be.
    void finish() const;
    /// "noon.toml:12: camera.altitude_m"; with an empty key the section itself.
    [[nodiscard]] std::string where(std::string_view key) const;
    [[noreturn]] void reject(std::string_view key, std::string_view value, std::string_view allowed) const;

private:
    friend class TomlDocument;
    struct Impl;
    explicit Section(std::shared_ptr<Impl> impl);
    std::shared_ptr<Impl> impl_;
};

class TomlDocument {
public:
    /// Throws Error: io (unreadable), invalid_argument (not TOML).
    explicit TomlDocument(const std::filesystem::path& path);
    TomlDocument(std::string_view text, const std::string& name);
    [[nodiscard]] Section root() const;

private:
    std::shared_ptr<Section::Impl> root_;
};

}  // namespace aureole::app
