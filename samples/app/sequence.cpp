#include "app/sequence.h"

#include <aureole/rhi/error.h>

#include <charconv>

namespace aureole::app {
namespace {

std::string padded(std::uint32_t number, std::size_t digits) {
    std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

}  // namespace

SunPath parse_sun_path(const std::string& text, std::uint32_t frames) {
    SunPath path{0, 0, frames};
    const char *first = text.data(), *end = text.data() + text.size();
    const auto from = std::from_chars(first, end, path.from_deg);
    const bool colon = from.ec == std::errc() && from.ptr != end && *from.ptr == ':';
    const auto to =
        colon ? std::from_chars(from.ptr + 1, end, path.to_deg) : std::from_chars_result{first, std::errc::invalid_argument};
    const auto inside = [](double degrees) { return degrees >= -90 && degrees <= 90; };  // false for NaN
    if (to.ec != std::errc() || to.ptr != end || !inside(path.from_deg) || !inside(path.to_deg))
        throw Error(ErrorCode::invalid_argument, "--sun-elevation", "\"" + text + "\"",
                    "FROM:TO in degrees, each in [-90, 90]");
    return path;
}

std::filesystem::path numbered(const std::filesystem::path& path, std::uint32_t number) {
    const std::string name = path.filename().string();
    const std::size_t percent = name.find('%');
    if (percent == std::string::npos)
        return path.parent_path() / (path.stem().string() + "-" + padded(number, 4) + path.extension().string());
    std::size_t after = percent + 1, digits = 1;
    if (after + 1 < name.size() && name[after] == '0' && name[after + 1] >= '1' && name[after + 1] <= '9') {
        digits = static_cast<std::size_t>(name[after + 1] - '0');
        after += 2;
    }
    if (after >= name.size() || name[after] != 'd' || name.find('%', after) != std::string::npos)
        throw Error(ErrorCode::invalid_argument, "--output", path.string(), "at most one %d or %04d in the name of a sequence");
    return path.parent_path() / (name.substr(0, percent) + padded(number, digits) + name.substr(after + 1));
}

}  // namespace aureole::app
