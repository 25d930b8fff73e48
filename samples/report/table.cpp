#include "report/table.h"

namespace aureole::app::report {

std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

std::string join(std::span<const std::string> texts, std::string_view separator) {
    std::string out;
    for (const std::string& text : texts) out.append(out.empty() ? "" : separator).append(text);
    return out;
}

std::string row(const std::vector<std::string>& cells) { return "| " + join(cells, " | ") + " |\n"; }

std::string header(const std::vector<std::string>& titles) {
    std::string rule = "|---|";
    for (std::size_t i = 1; i < titles.size(); ++i) rule += "---:|";
    return row(titles) + rule + "\n";
}

}  // namespace aureole::app::report
