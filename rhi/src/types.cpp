#include <aureole/rhi/types.h>

namespace aureole::rhi {

std::uint32_t bytes_per_texel(Format format) noexcept {
    switch (format) {
        case Format::undefined:
            return 0;
        case Format::r8_unorm:
            return 1;
        case Format::r16_float:
            return 2;
        case Format::rgba8_unorm:
        case Format::rgba8_srgb:
        case Format::bgra8_unorm:
        case Format::rg16_float:
        case Format::r32_float:
        case Format::r11g11b10_float:
        case Format::d32_float:
            return 4;
        case Format::rgba16_float:
        case Format::rg32_float:
            return 8;
        case Format::rgba32_float:
            return 16;
    }
    return 0;
}

std::uint32_t channel_count(Format format) noexcept {
    switch (format) {
        case Format::undefined:
            return 0;
        case Format::r8_unorm:
        case Format::r16_float:
        case Format::r32_float:
        case Format::d32_float:
            return 1;
        case Format::rg16_float:
        case Format::rg32_float:
            return 2;
        case Format::r11g11b10_float:
            return 3;
        case Format::rgba8_unorm:
        case Format::rgba8_srgb:
        case Format::bgra8_unorm:
        case Format::rgba16_float:
        case Format::rgba32_float:
            return 4;
    }
    return 0;
}

const char* to_string(Format format) noexcept {
    switch (format) {
        case Format::undefined:
            return "undefined";
        case Format::r8_unorm:
            return "r8_unorm";
        case Format::rgba8_unorm:
            return "rgba8_unorm";
        case Format::rgba8_srgb:
            return "rgba8_srgb";
        case Format::bgra8_unorm:
            return "bgra8_unorm";
        case Format::r16_float:
            return "r16_float";
        case Format::rg16_float:
            return "rg16_float";
        case Format::rgba16_float:
            return "rgba16_float";
        case Format::r32_float:
            return "r32_float";
        case Format::rg32_float:
            return "rg32_float";
        case Format::rgba32_float:
            return "rgba32_float";
        case Format::r11g11b10_float:
            return "r11g11b10_float";
        case Format::d32_float:
            return "d32_float";
    }
    return "unknown";
}

const char* to_string(State state) noexcept {
    switch (state) {
        case State::undefined:
            return "undefined";
        case State::sampled:
            return "sampled";
        case State::depth_read:
            return "depth_read";
        case State::storage_write:
            return "storage_write";
        case State::color_attachment:
            return "color_attachment";
        case State::copy_source:
            return "copy_source";
        case State::copy_destination:
            return "copy_destination";
        case State::constants:
            return "constants";
        case State::general:
            return "general";
    }
    return "unknown";
}

const char* to_string(Dimension dimension) noexcept {
    switch (dimension) {
        case Dimension::d2:
            return "2d";
        case Dimension::d3:
            return "3d";
        case Dimension::cube:
            return "cube";
    }
    return "unknown";
}

}  // namespace aureole::rhi
