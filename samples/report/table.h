// Tables in Markdown.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app::report {

/// A name as a table's cell takes it.
[[nodiscard]] std::string cell(std::string_view text);
[[nodiscard]] std::string join(std::span<const std::string> texts, std::string_view separator);
[[nodiscard]] std::string row(const std::vector<std::string>& cells);
/// The first column is text, the others numbers.
[[nodiscard]] std::string header(const std::vector<std::string>& titles);

}  // namespace aureole::app::report
