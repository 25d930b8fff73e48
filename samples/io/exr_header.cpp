#include "io/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace aureole::app {
namespace {

constexpr std::size_t longest_name = 255;
constexpr std::uint64_t most_tile_points = 1 << 24;
constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t multi_part = 0x1000;  // among the flags beside the version

/// Reads on, and never beyond the end.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::size_t left() const { return bytes_.size(); }
    std::span<const std::byte> take(std::size_t count) {
        if (count > bytes_.size()) throw std::runtime_error("the file ends too early");
        return std::exchange(bytes_, bytes_.subspan(count)).first(count);
    }
    std::uint32_t number() {
        std::uint32_t value = 0;
        int shift = 0;
        for (const std::byte byte : take(4)) value |= std::to_integer<std::uint32_t>(byte) << shift, shift += 8;
        return value;
    }
    /// Up to the byte 0 behind it, which goes with it.
    std::string name() {
        const auto end = std::ranges::find(bytes_, std::byte{0});
        const auto length = static_cast<std::size_t>(end - bytes_.begin());
        if (end == bytes_.end()) throw std::runtime_error("the file ends too early");
        if (length > longest_name) throw std::runtime_error("a name is longer than 255 characters");
        const std::span<const std::byte> text = take(length + 1);
        return {reinterpret_cast<const char*>(text.data()), length};
    }

private:
    std::span<const std::byte> bytes_;
};

/// Types of one length.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 24> lengths{{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

void skip_channels(Reader& value) {
    while (!value.name().empty()) (void)value.take(16);  // type, linear, sampling
}

void skip_preview(Reader& value) {
    const std::uint64_t width = value.number(), height = value.number();
    if (width > value.left() || height > value.left() || width * height > value.left())
        throw std::runtime_error("the file ends too early");
    (void)value.take(static_cast<std::size_t>(4 * width * height));
}

void skip_strings(Reader& value) {
    while (value.left() > 0) (void)value.take(value.number());
}

/// Whether the C++ reader takes all of an attribute's bytes, and no more. Of other types it takes as many as there are said to
/// be.
bool is_whole(std::string_view type, std::span<const std::byte> bytes) {
    const auto length = std::ranges::find(lengths, type, &decltype(lengths)::value_type::first);
    if (length != lengths.end()) return bytes.size() == length->second;
    if (type == "floatvector") return bytes.size() % 4 == 0;
    if (type == "idmanifest") return bytes.size() >= 4;  // how long it is when it is unpacked
    Reader value(bytes);
    try {
        if (type == "chlist")
            skip_channels(value);
        else if (type == "preview")
            skip_preview(value);
        else if (type == "stringvector")
            skip_strings(value);
        else
            return true;
    } catch (const std::runtime_error&) {
        return false;
    }
    return value.left() == 0;
}

/// Of a tile, room is made for all points, however few the picture has.
void check_tile(std::span<const std::byte> bytes) {
    Reader value(bytes);
    const std::uint64_t width = value.number(), height = value.number();
    if (width > most_tile_points || height > most_tile_points || width * height > most_tile_points)
        throw std::runtime_error("a tile of " + std::to_string(width) + "x" + std::to_string(height) +
                                 " points is not allowed; allowed: at most " + std::to_string(most_tile_points));
}

/// What a message can hold.
std::string printable(std::string text) {
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return '"' + text + '"';
}

/// False for an empty one, which ends the headers of several parts.
bool skip_header(Reader& file) {
    bool empty = true;
    for (std::string name = file.name(); !name.empty(); name = file.name(), empty = false) {
        const std::string type = file.name();
        const std::uint32_t length = file.number();
        const std::string what = "attribute " + printable(name) + " of type " + printable(type);
        if (length > file.left())
            throw std::runtime_error(what + " promises " + std::to_string(length) + " bytes where the file has " +
                                     std::to_string(file.left()));
        const std::span<const std::byte> value = file.take(length);
        if (!is_whole(type, value))
            throw std::runtime_error(what + " is not of the length that it says, " + std::to_string(length) + " bytes");
        if (type == "tiledesc") check_tile(value);
    }
    return !empty;
}

}  // namespace

void check_exr_header(std::span<const std::byte> file) {
    Reader reader(file);
    if (reader.number() != magic) throw std::runtime_error("it does not start as one");
    const std::uint32_t flags = reader.number();
    if (!skip_header(reader)) throw std::runtime_error("the header is empty");
    while ((flags & multi_part) != 0 && skip_header(reader)) {
    }
}

}  // namespace aureole::app
