// A table of a page of the documentation.
#pragma once

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace aureole::docs {

/// Cells of a row, without blanks and backquotes.
inline std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) {
        std::erase_if(cell, [](char c) { return c == ' ' || c == '`'; });
        result.push_back(cell);
    }
    return result;
}

/// Rows of the table whose heading starts so, by their first cell, which they are without; the heading is one of them.
inline std::map<std::string, std::vector<std::string>> page_table(const char* file, const std::string& heading) {
    std::ifstream page(file);
    std::map<std::string, std::vector<std::string>> rows;
    for (std::string line; std::getline(page, line);) {
        if (rows.empty() && !line.starts_with(heading)) continue;
        if (!line.starts_with("|")) break;
        std::vector<std::string> row = cells(line);
        const std::string name = row.front();
        row.erase(row.begin());
        if (!name.starts_with("---")) rows[name] = row;
    }
    return rows;
}

}  // namespace aureole::docs
