#include <aureole/rhi/error.h>
#include <aureole/rhi/texel.h>
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "small_float.h"

using namespace aureole::rhi;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Value of a half by its definition, written independently of the code under test.
double half_value(int bits) {
    const int exponent = (bits >> 10) & 31, mantissa = bits & 1023;
    const double magnitude = exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return bits & 0x8000 ? -magnitude : magnitude;
}

template <class real>
std::vector<std::byte> encoded(Format format, real r, real g, real b, real a) {
    std::vector<std::byte> bytes(bytes_per_texel(format));
    const real texel[4] = {r, g, b, a};
    encode_texel(format, texel, bytes.data());
    return bytes;
}

int byte(const std::vector<std::byte>& bytes, std::size_t i) { return std::to_integer<int>(bytes[i]); }

}  // namespace

TEST_CASE("every half decodes to its defined value and encodes back to itself") {
    int wrong = 0;
    for (int bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        if (((bits >> 10) & 31) == 31) continue;
        wrong += from_half<double>(half) != half_value(bits) || static_cast<double>(from_half<float>(half)) != half_value(bits);
        wrong += to_half(from_half<double>(half)) != half || to_half(from_half<float>(half)) != half;
    }
    CHECK(wrong == 0);
}

TEST_CASE("halves round to nearest, ties to even, in float and double") {
    int wrong = 0;
    for (int bits = 0; bits < 0x7bff; ++bits) {  // every pair of neighbours, denormals included
        const double low = half_value(bits), high = half_value(bits + 1), middle = (low + high) / 2;
        const int even = bits % 2 == 0 ? bits : bits + 1;
        wrong += to_half(middle) != even || to_half(static_cast<float>(middle)) != even;
        wrong += to_half(-middle) != (even | 0x8000);
        wrong += to_half(std::nextafter(middle, 0.0)) != bits || to_half(std::nextafter(middle, infinity)) != bits + 1;
        wrong += to_half(std::nextafter(static_cast<float>(middle), 0.0f)) != bits;
        wrong += to_half(std::nextafter(static_cast<float>(middle), 1e9f)) != bits + 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("halves at the ends of the range") {
    CHECK(to_half(65504.0) == 0x7bff);
    CHECK(to_half(65519.999) == 0x7bff);
    CHECK(to_half(65520.0) == 0x7c00);  // half way to 65536: to even, which is infinity
    CHECK(to_half(-65520.0f) == 0xfc00);
    CHECK(to_half(1e30f) == 0x7c00);
    CHECK(to_half(infinity) == 0x7c00);
    CHECK(to_half(std::ldexp(1.0, -25)) == 0);  // half of the smallest denormal: to even
    CHECK(to_half(std::ldexp(1.001, -25)) == 1);
    CHECK(to_half(std::numeric_limits<double>::denorm_min()) == 0);
    CHECK(to_half(-0.0) == 0x8000);
    CHECK(std::isnan(from_half<float>(to_half(std::numeric_limits<float>::quiet_NaN()))));
    CHECK(std::isinf(from_half<double>(0xfc00)));
    // Rounding a double through float first would give 0x3c01 here.
    CHECK(to_half(1.0 + std::ldexp(1.0, -11) - std::ldexp(1.0, -40)) == 0x3c00);
}

TEST_CASE("r11g11b10: unsigned floats with 6 and 5 bits of mantissa") {
    int wrong = 0;
    for (std::uint32_t bits = 0; bits < (31u << 6); ++bits)
        wrong += to_unsigned_float<6>(decode_magnitude<6, double>(bits)) != bits ||
                 to_unsigned_float<6>(decode_magnitude<6, float>(bits)) != bits;
    for (std::uint32_t bits = 0; bits < (31u << 5); ++bits)
        wrong += to_unsigned_float<5>(decode_magnitude<5, float>(bits)) != bits;
    CHECK(wrong == 0);

    double texel[4] = {1.0 + 1.0 / 128, -3, 1e9, 0.25};
    quantize(Format::r11g11b10_float, texel);
    CHECK(texel[0] == 1.0);      // tie to even
    CHECK(texel[1] == 0.0);      // no negatives
    CHECK(texel[2] == 64512.0);  // finite stays finite
    CHECK(texel[3] == 1.0);
    float more[4] = {65024.0f, std::numeric_limits<float>::infinity(), 1.0f + 3.0f / 64, 0};
    quantize(Format::r11g11b10_float, more);
    CHECK(more[0] == 65024.0f);
    CHECK(std::isinf(more[1]));
    CHECK(more[2] == 1.0625f);
    // Red in the low bits.
    const auto bytes = encoded(Format::r11g11b10_float, 1.0f, 0.0f, 0.0f, 0.0f);
    CHECK(byte(bytes, 0) == 0xc0);
    CHECK(byte(bytes, 1) == 0x03);
    CHECK(byte(bytes, 2) + byte(bytes, 3) == 0);
}

TEST_CASE("unorm8 rounds to nearest and clamps") {
    for (int code = 0; code < 256; ++code) {
        CAPTURE(code);
        CHECK(byte(encoded(Format::r8_unorm, static_cast<float>(code) / 255.0f, 0.0f, 0.0f, 0.0f), 0) == code);
        const double edge = (code + 0.5) / 255;
        CHECK(byte(encoded(Format::r8_unorm, edge - 1e-12, 0.0, 0.0, 0.0), 0) == code);
        CHECK(byte(encoded(Format::r8_unorm, edge + 1e-12, 0.0, 0.0, 0.0), 0) == std::min(code + 1, 255));
    }
    // 1/2 * 255 = 127.5 exactly: to even.
    CHECK(byte(encoded(Format::r8_unorm, 0.5, 0.0, 0.0, 0.0), 0) == 128);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto bytes = encoded(Format::rgba8_unorm, -1.0f, 2.0f, nan, std::numeric_limits<float>::infinity());
    CHECK(byte(bytes, 0) == 0);
    CHECK(byte(bytes, 1) == 255);
    CHECK(byte(bytes, 2) == 0);
    CHECK(byte(bytes, 3) == 255);
    const auto swapped = encoded(Format::bgra8_unorm, 1.0f, 0.5f, 0.0f, 0.2f);
    CHECK(byte(swapped, 0) == 0);
    CHECK(byte(swapped, 1) == 128);
    CHECK(byte(swapped, 2) == 255);
    CHECK(byte(swapped, 3) == 51);
}

TEST_CASE("srgb8 takes the nearest code on the sRGB scale") {
    const auto linear = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
    for (int code = 0; code < 256; ++code) {
        CAPTURE(code);
        float texel[4];
        const std::byte packed[4] = {std::byte(code), std::byte(0), std::byte(0), std::byte(code)};
        decode_texel(Format::rgba8_srgb, packed, texel);
        CHECK(texel[0] == doctest::Approx(linear(code / 255.0)).scale(1e-300).epsilon(1e-6));
        CHECK(texel[3] == static_cast<float>(code) / 255.0f);  // alpha is linear
        CHECK(byte(encoded(Format::rgba8_srgb, texel[0], 0.0f, 0.0f, 0.0f), 0) == code);
        CHECK(byte(encoded(Format::rgba8_srgb, linear((code + 0.499) / 255), 0.0, 0.0, 0.0), 0) == code);
        CHECK(byte(encoded(Format::rgba8_srgb, linear((code - 0.499) / 255), 0.0, 0.0, 0.0), 0) == code);
    }
    CHECK(byte(encoded(Format::rgba8_srgb, 7.0, 0.0, 0.0, 0.0), 0) == 255);
    CHECK(byte(encoded(Format::rgba8_srgb, std::nan(""), 0.0, 0.0, 0.0), 0) == 0);
}

TEST_CASE("missing channels read as zero and one") {
    for (const Format format : {Format::r8_unorm, Format::r16_float, Format::r32_float, Format::d32_float, Format::rg16_float,
                                Format::rg32_float, Format::r11g11b10_float}) {
        CAPTURE(std::string(to_string(format)));
        double rounded[4] = {0.5, 0.25, 0.125, 0.0625}, confined[4] = {0.5, 0.25, 0.125, 0.0625};
        quantize(format, rounded);
        confine(format, confined);
        const std::uint32_t channels = channel_count(format);
        CHECK(rounded[1] == (channels > 1 ? 0.25 : 0.0));
        CHECK(rounded[2] == (channels > 2 ? 0.125 : 0.0));
        CHECK(rounded[3] == 1.0);
        CHECK(confined[0] == 0.5);
        for (int i = 1; i < 4; ++i) CHECK(confined[i] == rounded[i]);
    }
}

TEST_CASE("confine keeps every bit inside the format's range") {
    double texel[4] = {0.1, 1.5, -2.0, std::nan("")};
    confine(Format::rgba8_srgb, texel);
    CHECK(texel[0] == 0.1);
    CHECK(texel[1] == 1.0);
    CHECK(texel[2] == 0.0);
    CHECK(texel[3] == 0.0);
    double large[4] = {1e9, -1e-9, 1e-30, 3};
    confine(Format::rgba16_float, large);
    CHECK(large[0] == 1e9);
    CHECK(large[1] == -1e-9);
    CHECK(large[2] == 1e-30);
    confine(Format::r11g11b10_float, large);
    CHECK(large[1] == 0.0);
}

TEST_CASE("arrays of texels round-trip, and wrong sizes are refused") {
    const float rgba[8] = {0.1f, -2.5f, 3e-7f, 1.0f, 70000.0f, 0.0f, -0.0f, 2.0f};
    std::vector<std::byte> packed(32);
    float back[8];
    encode_texels(Format::rgba32_float, rgba, packed);
    decode_texels(Format::rgba32_float, packed, back);
    for (std::size_t i = 0; i < 8; ++i)  // by bits: -0 is not 0
        CHECK(std::bit_cast<std::uint32_t>(back[i]) == std::bit_cast<std::uint32_t>(rgba[i]));

    std::vector<std::byte> halves(16);
    double doubles[8];
    encode_texels(Format::rgba16_float, std::span<const float>(rgba), halves);
    decode_texels(Format::rgba16_float, halves, doubles);
    CHECK(doubles[1] == -2.5);
    CHECK(std::isinf(doubles[4]));

    CHECK_THROWS_AS(decode_texels(Format::rgba16_float, packed, back), aureole::Error);
    CHECK_THROWS_AS(encode_texels(Format::undefined, std::span<const float>(rgba), packed), aureole::Error);
    CHECK_THROWS_AS(encode_texels(Format::rgba32_float, std::span<const float>(rgba, 7), packed), aureole::Error);
}
