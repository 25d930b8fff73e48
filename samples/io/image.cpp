#include "io/image.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <string>

namespace aureole::app {

void check_grey_size(const std::filesystem::path& path, std::uint64_t width, std::uint64_t height) {
    constexpr std::uint64_t longest_side = 32768, most_points = std::uint64_t{1} << 28;
    if (std::min(width, height) >= 2 && std::max(width, height) <= longest_side && width * height <= most_points) return;
    throw Error(ErrorCode::invalid_argument, path.string() + ": size", std::to_string(width) + "x" + std::to_string(height),
                "2 to 32768 points a side, at most 268435456 in all");
}

}  // namespace aureole::app
