// What `aureole measure` has written, for people: a page for the browser, tables for Markdown, and comma-separated values.
//
// `source` names the data in messages. Each function throws Error as read_measurements does (measurements.h).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace aureole::app {

/// One page of HTML that holds everything it shows: it opens from a disk, without a network. Throws Error(unsupported) if this
/// program was built without the page (no npm).
[[nodiscard]] std::string html_page(const nlohmann::json& measurements, const std::string& source = "measurements");
/// Writes it. Throws Error(io) if the file cannot be written.
void write_report(const nlohmann::json& measurements, const std::filesystem::path& html,
                  const std::string& source = "measurements");

/// For each class of scenes: settings with errors and costs; what the errors are made of; what each simplification costs.
/// GitHub-flavoured, headings of the second level.
[[nodiscard]] std::string markdown_tables(const nlohmann::json& measurements, const std::string& source = "measurements");

/// The two tables of markdown_tables that a reader wants first, without a heading.
[[nodiscard]] std::string markdown_overview(const nlohmann::json& measurements, const std::string& source = "measurements");

/// A line for each result with everything about its scene and setting; errors as fractions, cells that were not measured empty,
/// infinite errors `inf`.
[[nodiscard]] std::string csv_lines(const nlohmann::json& measurements, const std::string& source = "measurements");

}  // namespace aureole::app
