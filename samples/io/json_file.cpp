#include "io/json_file.h"

#include "io/file.h"

#include <aureole/rhi/error.h>

namespace aureole::app {

nlohmann::json read_json(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& problem) {
        throw Error(ErrorCode::invalid_argument, path.string() + ": is no JSON: " + problem.what());
    }
}

}  // namespace aureole::app
