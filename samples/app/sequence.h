// Numbered pictures of a moving sun.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace aureole::app {

struct SunPath {
    double from_deg = 0, to_deg = 0;
    std::uint32_t frames = 2;
    [[nodiscard]] double elevation_deg(std::uint32_t frame) const {
        return frames < 2 ? from_deg : from_deg + (to_deg - from_deg) * frame / (frames - 1);
    }
};
/// "FROM:TO" in degrees. Throws Error(invalid_argument).
[[nodiscard]] SunPath parse_sun_path(const std::string& text, std::uint32_t frames);

/// The name of picture `number`: in the place of %0Nd (N from 1 to 9) or %d, else "-0001" before the extension. Throws
/// Error(invalid_argument) for any other %, and for more than one.
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& path, std::uint32_t number);

}  // namespace aureole::app
