#include "io/csv.h"

#include "io/file.h"

#include <aureole/rhi/error.h>

#include <charconv>
#include <cmath>

namespace aureole::app {
namespace {

std::string_view trim(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    while (true) {
        const std::size_t end = line.find(separator);
        cells.push_back(trim(line.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

/// Where a message points: "sky.csv:12".
std::string place(const std::string& file, int line) { return file + ":" + std::to_string(line); }

double read_cell(std::string_view cell, const std::string& where, std::string_view column) {
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (problem != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
        throw Error(ErrorCode::invalid_argument, where + ": " + std::string(column), "\"" + std::string(cell) + "\"",
                    "a finite number");
    return value;
}

std::vector<std::size_t> find_columns(const std::vector<std::string_view>& header, std::span<const std::string_view> names,
                                      const std::string& where) {
    std::vector<std::size_t> indices;
    for (const std::string_view name : names) {
        std::size_t found = header.size();
        for (std::size_t i = 0; i < header.size(); ++i) {
            if (header[i] != name) continue;
            if (found != header.size())
                throw Error(ErrorCode::invalid_argument, where + ": column " + std::string(name) + " appears twice");
            found = i;
        }
        if (found == header.size()) {
            std::string known;
            for (const std::string_view h : header) known.append(known.empty() ? "" : ",").append(h);
            throw Error(ErrorCode::invalid_argument,
                        std::string(where).append(": column ").append(name).append(" is missing; there are: ").append(known));
        }
        indices.push_back(found);
    }
    return indices;
}

template <class Real>
std::string print(Real value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

CsvTable parse_csv(const std::string& text, const std::string& file_name, std::span<const std::string_view> names) {
    CsvTable table;
    table.columns.resize(names.size());
    std::vector<std::size_t> indices;
    std::size_t width = 0;
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // a byte-order mark
    int number = 0;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trim(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        ++number;
        if (line.empty()) continue;
        if (line.front() == '#') {
            table.comments.emplace_back(trim(line.substr(1)));
            continue;
        }
        const std::vector<std::string_view> cells = split(line, ',');
        if (width == 0) {
            indices = find_columns(cells, names, place(file_name, number));
            width = cells.size();
            continue;
        }
        if (cells.size() != width)
            throw Error(ErrorCode::invalid_argument, place(file_name, number), std::to_string(cells.size()) + " cells",
                        std::to_string(width) + ", as many as there are columns");
        for (std::size_t c = 0; c < names.size(); ++c)
            table.columns[c].push_back(read_cell(cells[indices[c]], place(file_name, number), names[c]));
        table.lines.push_back(number);
    }
    if (table.rows() == 0) throw Error(ErrorCode::invalid_argument, file_name + ": holds no row of numbers");
    return table;
}

CsvTable read_csv(const std::filesystem::path& path, std::span<const std::string_view> names) {
    return parse_csv(read_text(path), path.string(), names);
}

std::string print_number(double value) { return print(value); }
std::string print_number(float value) { return print(value); }

std::string print_number(double value, int digits) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

}  // namespace aureole::app
