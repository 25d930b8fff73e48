// Grids of heights, from whatever file holds them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aureole::app {

/// Heights above the planet's ground radius at the points of a regular grid. Row 0 is the northern edge, column 0 the western.
struct HeightMap {
    std::uint32_t width = 0, height = 0;  ///< Points, at least 2 each.
    std::vector<float> meters;            ///< Row by row.
    double spacing_east_m = 0;            ///< Between columns.
    double spacing_north_m = 0;           ///< Between rows.
};

/// What a file may not say by itself.
struct HeightMapOptions {
    std::optional<double> spacing_m;  ///< Between points, both ways. > 0. Needed unless the file says (an .npz may).
    double meters_per_unit = 1;       ///< Height of one unit of the file. Finite, not 0.
    double offset_m = 0;              ///< Added to every height. Finite.
    [[nodiscard]] bool operator==(const HeightMapOptions&) const = default;
};

/// By the file's extension:
///   .npz  the array "elevation" or the only one, of rows and columns; numbers dx, dy (degrees) with ymin, ymax (degrees
///         of latitude) beside it give the spacing on Earth, as in Matplotlib's sample grid
///   .png  8- or 16-bit greyscale
///   .exr  channel Y or R or the only one
/// The name "jacksboro" is that sample grid, where Debian's python-matplotlib-data puts it.
/// Throws Error: io (unreadable, truncated), invalid_argument (wrong shape, a height that is no finite number or beyond
/// 100 km, fewer than 2 or more than 32768 points a side or more than 2^28 in all, an option out of range or missing).
[[nodiscard]] HeightMap read_height_map(const std::filesystem::path& path, const HeightMapOptions& options);

}  // namespace aureole::app
