// Tables of numbers as comma-separated values: a header line with the columns' names, then a line a row. Lines that start with
// # are comments; empty lines are skipped.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::app {

/// The columns that were asked for, in the order of the request.
struct CsvTable {
    std::vector<std::string> comments;         ///< Without the leading "# ".
    std::vector<std::vector<double>> columns;  ///< columns[c][row], all finite.
    std::vector<int> lines;                    ///< Line number of each row, for messages.

    [[nodiscard]] std::size_t rows() const noexcept { return lines.size(); }
};

/// Other columns are ignored, whatever they hold. Throws Error: io (unreadable), invalid_argument (a missing or doubled column,
/// a cell that is no finite number, a row that is too short or long, no row at all), each with file and line.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path, std::span<const std::string_view> names);
[[nodiscard]] CsvTable parse_csv(const std::string& text, const std::string& file_name,
                                 std::span<const std::string_view> names);

/// Shortest text that reads back as the same number.
[[nodiscard]] std::string print_number(double value);
[[nodiscard]] std::string print_number(float value);
/// With so many significant digits at most.
[[nodiscard]] std::string print_number(double value, int digits);

}  // namespace aureole::app
