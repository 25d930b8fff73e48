#include <aureole/rhi/error.h>
#include <aureole/rhi/kernel/cpu_kernel.h>
#include <aureole/rhi/texel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "small_float.h"

namespace aureole::rhi {
namespace {

template <class T>
T load(const std::byte* bytes) noexcept {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}
template <class T>
void save(std::byte* bytes, T value) noexcept {
    std::memcpy(bytes, &value, sizeof value);
}

double clamp_unit(double value) noexcept {
    return value > 0 ? (value < 1 ? value : 1) : 0;  // NaN gives 0
}

std::uint8_t encode_unorm8(double value) noexcept {
    const double x = clamp_unit(value);
    const double low = std::floor(x * 255);
    // The exact sign of x * 255 - (low + 1/2): fma rounds only once. The only tie is 1/2, and goes to 128, the even code.
    const double above = std::fma(x, 255.0, -(low + 0.5));
    return static_cast<std::uint8_t>(above >= 0 ? low + 1 : low);
}

double srgb_to_linear(double s) noexcept { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

/// Linear value of every sRGB code, and the linear values at which the nearest code changes.
struct SrgbTables {
    std::array<double, 256> linear;
    std::array<double, 255> threshold;
    SrgbTables() noexcept {
        for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = srgb_to_linear(static_cast<double>(i) / 255);
        for (std::size_t i = 0; i < threshold.size(); ++i) threshold[i] = srgb_to_linear((static_cast<double>(i) + 0.5) / 255);
    }
};
const SrgbTables& srgb_tables() noexcept {
    static const SrgbTables tables;
    return tables;
}

std::uint8_t encode_srgb8(double linear) noexcept {
    const auto& threshold = srgb_tables().threshold;
    const auto code = std::lower_bound(threshold.begin(), threshold.end(), clamp_unit(linear)) - threshold.begin();
    return static_cast<std::uint8_t>(code);
}

template <class real>
void decode(Format format, const std::byte* p, real t[4]) noexcept {
    const auto unorm = [&](std::size_t i) { return static_cast<real>(std::to_integer<int>(p[i])) / real(255); };
    const auto srgb = [&](std::size_t i) {
        return static_cast<real>(srgb_tables().linear[std::to_integer<std::size_t>(p[i])]);
    };
    const auto half = [&](std::size_t i) { return from_half<real>(load<std::uint16_t>(p + 2 * i)); };
    const auto full = [&](std::size_t i) { return static_cast<real>(load<float>(p + 4 * i)); };
    const auto set = [&](real r, real g, real b, real a) { t[0] = r, t[1] = g, t[2] = b, t[3] = a; };
    switch (format) {
        case Format::undefined:
            break;
        case Format::r8_unorm:
            set(unorm(0), 0, 0, 1);
            break;
        case Format::rgba8_unorm:
            set(unorm(0), unorm(1), unorm(2), unorm(3));
            break;
        case Format::rgba8_srgb:
            set(srgb(0), srgb(1), srgb(2), unorm(3));
            break;
        case Format::bgra8_unorm:
            set(unorm(2), unorm(1), unorm(0), unorm(3));
            break;
        case Format::r16_float:
            set(half(0), 0, 0, 1);
            break;
        case Format::rg16_float:
            set(half(0), half(1), 0, 1);
            break;
        case Format::rgba16_float:
            set(half(0), half(1), half(2), half(3));
            break;
        case Format::r32_float:
        case Format::d32_float:
            set(full(0), 0, 0, 1);
            break;
        case Format::rg32_float:
            set(full(0), full(1), 0, 1);
            break;
        case Format::rgba32_float:
            set(full(0), full(1), full(2), full(3));
            break;
        case Format::r11g11b10_float: {
            const auto word = load<std::uint32_t>(p);
            set(decode_magnitude<6, real>(word & 0x7ffu), decode_magnitude<6, real>((word >> 11) & 0x7ffu),
                decode_magnitude<5, real>(word >> 22), 1);
            break;
        }
    }
}

template <class real>
void encode(Format format, const real t[4], std::byte* p) noexcept {
    const auto unorm = [&](std::size_t i, real v) { save(p + i, encode_unorm8(static_cast<double>(v))); };
    const auto srgb = [&](std::size_t i, real v) { save(p + i, encode_srgb8(static_cast<double>(v))); };
    const auto half = [&](std::size_t i) { save(p + 2 * i, to_half(t[i])); };
    const auto full = [&](std::size_t i) { save(p + 4 * i, static_cast<float>(t[i])); };
    switch (format) {
        case Format::undefined:
            break;
        case Format::r8_unorm:
            unorm(0, t[0]);
            break;
        case Format::rgba8_unorm:
            unorm(0, t[0]), unorm(1, t[1]), unorm(2, t[2]), unorm(3, t[3]);
            break;
        case Format::rgba8_srgb:
            srgb(0, t[0]), srgb(1, t[1]), srgb(2, t[2]), unorm(3, t[3]);
            break;
        case Format::bgra8_unorm:
            unorm(0, t[2]), unorm(1, t[1]), unorm(2, t[0]), unorm(3, t[3]);
            break;
        case Format::r16_float:
            half(0);
            break;
        case Format::rg16_float:
            half(0), half(1);
            break;
        case Format::rgba16_float:
            half(0), half(1), half(2), half(3);
            break;
        case Format::r32_float:
        case Format::d32_float:
            full(0);
            break;
        case Format::rg32_float:
            full(0), full(1);
            break;
        case Format::rgba32_float:
            full(0), full(1), full(2), full(3);
            break;
        case Format::r11g11b10_float:
            save(p, to_unsigned_float<6>(t[0]) | (to_unsigned_float<6>(t[1]) << 11) | (to_unsigned_float<5>(t[2]) << 22));
            break;
    }
}

template <class real>
void round_trip(Format format, real t[4]) noexcept {
    std::byte packed[16] = {};
    encode(format, t, packed);
    decode(format, packed, t);
}

template <class real>
void confine_texel(Format format, real t[4]) noexcept {
    const std::uint32_t channels = channel_count(format);
    for (std::uint32_t i = channels; i < 4; ++i) t[i] = i == 3 ? real(1) : real(0);
    switch (format) {
        case Format::r8_unorm:
        case Format::rgba8_unorm:
        case Format::rgba8_srgb:
        case Format::bgra8_unorm:
            for (std::uint32_t i = 0; i < channels; ++i) t[i] = static_cast<real>(clamp_unit(static_cast<double>(t[i])));
            break;
        case Format::r11g11b10_float:
            for (std::uint32_t i = 0; i < channels; ++i) t[i] = t[i] < 0 ? real(0) : t[i];
            break;
        default:
            break;
    }
}

void check_sizes(Format format, std::size_t packed_bytes, std::size_t numbers) {
    const std::size_t size = bytes_per_texel(format);
    if (size == 0) throw Error(ErrorCode::invalid_argument, "format", to_string(format), "any format but undefined");
    if (packed_bytes % size != 0 || numbers != packed_bytes / size * 4)
        throw Error(ErrorCode::invalid_argument, "rgba.size", std::to_string(numbers),
                    "4 for each " + std::to_string(size) + "-byte texel of the " + std::to_string(packed_bytes) +
                        " packed bytes of " + to_string(format));
}

template <class real>
void decode_all(Format format, std::span<const std::byte> packed, std::span<real> rgba) {
    check_sizes(format, packed.size(), rgba.size());
    const std::size_t size = bytes_per_texel(format);
    for (std::size_t i = 0; i < packed.size() / size; ++i) decode(format, packed.data() + i * size, rgba.data() + 4 * i);
}

template <class real>
void encode_all(Format format, std::span<const real> rgba, std::span<std::byte> packed) {
    check_sizes(format, packed.size(), rgba.size());
    const std::size_t size = bytes_per_texel(format);
    for (std::size_t i = 0; i < packed.size() / size; ++i) encode(format, rgba.data() + 4 * i, packed.data() + i * size);
}

}  // namespace

void decode_texel(Format format, const std::byte* packed, float rgba[4]) noexcept { decode(format, packed, rgba); }
void decode_texel(Format format, const std::byte* packed, double rgba[4]) noexcept { decode(format, packed, rgba); }
void encode_texel(Format format, const float rgba[4], std::byte* packed) noexcept { encode(format, rgba, packed); }
void encode_texel(Format format, const double rgba[4], std::byte* packed) noexcept { encode(format, rgba, packed); }

void decode_texels(Format format, std::span<const std::byte> packed, std::span<float> rgba) {
    decode_all(format, packed, rgba);
}
void decode_texels(Format format, std::span<const std::byte> packed, std::span<double> rgba) {
    decode_all(format, packed, rgba);
}
void encode_texels(Format format, std::span<const float> rgba, std::span<std::byte> packed) {
    encode_all(format, rgba, packed);
}
void encode_texels(Format format, std::span<const double> rgba, std::span<std::byte> packed) {
    encode_all(format, rgba, packed);
}

void quantize(Format format, float rgba[4]) noexcept { round_trip(format, rgba); }
void quantize(Format format, double rgba[4]) noexcept { round_trip(format, rgba); }
void confine(Format format, float rgba[4]) noexcept { confine_texel(format, rgba); }
void confine(Format format, double rgba[4]) noexcept { confine_texel(format, rgba); }

}  // namespace aureole::rhi
