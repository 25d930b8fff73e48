#include "io/json_file.h"

#include "io/file.h"

#include <aureole/rhi/error.h>

#include <algorithm>

namespace aureole::app {

namespace {
bool is_flat(const nlohmann::json& value) {
    return std::ranges::none_of(value, [](const nlohmann::json& element) { return element.is_structured(); });
}
}  // namespace

nlohmann::json read_json(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& problem) {
        throw Error(ErrorCode::invalid_argument, path.string() + ": is no JSON: " + problem.what());
    }
}

std::string show_json(const nlohmann::json& value) {
    constexpr std::size_t longest = 80;
    if (!is_flat(value))
        return (value.is_array() ? "an array of " : "an object of ") + std::to_string(value.size()) +
               (value.is_array() ? " elements" : " members");
    std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text.size() > longest) text = text.substr(0, longest - 3) + "...";
    return text;
}

}  // namespace aureole::app
