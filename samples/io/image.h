// Pictures in memory, and the files they become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace aureole::app {

/// What a display takes: sRGB-encoded red, green, blue, row by row from the top.
struct DisplayImage {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Scene-linear Rec.709 red, green, blue, row by row from the top.
struct LinearImage {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgb;
};

/// Both throw Error(io) and leave nothing behind if the file cannot be written.
void write_png(const std::filesystem::path& path, const DisplayImage& image);
void write_exr(const std::filesystem::path& path, const LinearImage& image);

/// A PNG file's bytes: linear values in [0, 1] (beyond them cut off) as sRGB of 8 bits.
[[nodiscard]] std::vector<std::byte> encode_png(const LinearImage& image);

/// One channel of numbers as the file stores them: a 8- or 16-bit greyscale PNG (0 .. 255 or 65535), or the channel "Y", "R" or
/// the only one of an EXR. Row by row from the top.
struct GreyImage {
    std::uint32_t width = 0, height = 0;
    std::vector<float> values;
};
/// Throws Error(invalid_argument) naming file and size unless it is one of a height map: 2 to 32768 points a side and at most
/// 2^28 in all. Readers ask before they make room for what a header promises.
void check_grey_size(const std::filesystem::path& path, std::uint64_t width, std::uint64_t height);
/// Both throw Error: io (unreadable, truncated, not such a file), invalid_argument (colours, no such channel, size).
[[nodiscard]] GreyImage read_png_grey(const std::filesystem::path& path);
[[nodiscard]] GreyImage read_exr_grey(const std::filesystem::path& path);

}  // namespace aureole::app
