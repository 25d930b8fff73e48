#include "physics/truth.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace aureole::physics {
namespace {

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
    return result;
}

}  // namespace

std::filesystem::path truth_file(const std::string& name) {
    const char* named = std::getenv("AUREOLE_TRUTH_DIR");
    return std::filesystem::path(named ? named : AUREOLE_TRUTH_TABLES) / name;
}

TruthTable read_truth(const std::string& name) {
    const std::filesystem::path path = truth_file(name);
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    TruthTable table;
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) {
            table.comment += line;
        } else if (names.empty()) {
            names = cells(line);
        } else {
            const std::vector<std::string> values = cells(line);
            if (values.size() != names.size()) throw std::runtime_error(path.string() + ": a row of the wrong length: " + line);
            for (table.rows.emplace_back(); const std::string& name : names)
                table.rows.back()[name] = values[static_cast<std::size_t>(&name - names.data())];
        }
    }
    if (table.rows.empty()) throw std::runtime_error(path.string() + ": holds no row");
    return table;
}

double number(const std::map<std::string, std::string>& row, const std::string& column) { return std::stod(row.at(column)); }

}  // namespace aureole::physics
