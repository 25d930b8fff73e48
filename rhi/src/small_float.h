// Conversion between IEEE binary32/binary64 and the small floats of texture formats: half (1+5+10 bits) and the unsigned
// 11- and 10-bit floats (5+6, 5+5 bits). Rounds once, to nearest even, denormals included.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace aureole::rhi {

/// Largest exponent field of the small floats: infinity and NaN.
inline constexpr std::uint32_t small_float_special = 31;

/// Exponent and mantissa bits of |value|, without the sign. Too large values become infinity.
template <int mantissa_bits, class real>
[[nodiscard]] constexpr std::uint32_t encode_magnitude(real value) noexcept {
    using Bits = std::conditional_t<sizeof(real) == 4, std::uint32_t, std::uint64_t>;
    constexpr int source_mantissa = std::numeric_limits<real>::digits - 1;
    constexpr int source_bias = std::numeric_limits<real>::max_exponent - 1;
    constexpr Bits mantissa_mask = (Bits{1} << source_mantissa) - 1;
    constexpr Bits magnitude_mask = std::numeric_limits<Bits>::max() >> 1;
    constexpr std::uint32_t infinity = small_float_special << mantissa_bits;

    const Bits magnitude = std::bit_cast<Bits>(value) & magnitude_mask;
    const Bits infinite = std::bit_cast<Bits>(std::numeric_limits<real>::infinity());
    if (magnitude > infinite) return infinity | (1u << (mantissa_bits - 1));  // a quiet NaN
    if (magnitude == infinite) return infinity;

    const int exponent = static_cast<int>(magnitude >> source_mantissa) - source_bias;
    if (exponent > 15) return infinity;
    if (exponent < -15 - mantissa_bits) return 0;  // less than half of the smallest denormal

    // Below the smallest normal number, 2^-14, the spacing no longer shrinks.
    const int below_normal = exponent < -14 ? -14 - exponent : 0;
    const int shift = source_mantissa - mantissa_bits + below_normal;
    const Bits significand = (magnitude & mantissa_mask) | (mantissa_mask + 1);
    const Bits odd = (significand >> shift) & 1;
    const Bits rounded = (significand + (Bits{1} << (shift - 1)) - 1 + odd) >> shift;

    // The leading one counts as one step of the exponent, and so does a carry out of the mantissa: up to infinity.
    const std::uint32_t exponent_field = below_normal > 0 ? 0u : static_cast<std::uint32_t>(exponent + 14);
    return (exponent_field << mantissa_bits) + static_cast<std::uint32_t>(rounded);
}

template <int mantissa_bits, class real>
[[nodiscard]] constexpr real decode_magnitude(std::uint32_t bits) noexcept {
    const std::uint32_t exponent = bits >> mantissa_bits;
    const std::uint32_t mantissa = bits & ((1u << mantissa_bits) - 1);
    if (exponent == small_float_special)
        return mantissa ? std::numeric_limits<real>::quiet_NaN() : std::numeric_limits<real>::infinity();
    // All factors are powers of two and the sums are exact.
    const real fraction = static_cast<real>(mantissa) / static_cast<real>(1u << mantissa_bits);
    if (exponent == 0) return fraction / real(1 << 14);
    const real significand = 1 + fraction;
    return exponent >= 15 ? significand * static_cast<real>(1u << (exponent - 15))
                          : significand / static_cast<real>(1u << (15 - exponent));
}

template <class real>
[[nodiscard]] constexpr std::uint16_t to_half(real value) noexcept {
    using Bits = std::conditional_t<sizeof(real) == 4, std::uint32_t, std::uint64_t>;
    const auto sign = static_cast<std::uint32_t>(std::bit_cast<Bits>(value) >> (8 * sizeof(real) - 1));
    return static_cast<std::uint16_t>((sign << 15) | encode_magnitude<10>(value));
}

template <class real>
[[nodiscard]] constexpr real from_half(std::uint16_t bits) noexcept {
    const real magnitude = decode_magnitude<10, real>(bits & 0x7fffu);
    return (bits & 0x8000u) ? -magnitude : magnitude;
}

/// The unsigned floats of r11g11b10_float: negative values become 0, finite values stay finite.
template <int mantissa_bits, class real>
[[nodiscard]] constexpr std::uint32_t to_unsigned_float(real value) noexcept {
    if (value < 0) return 0;
    constexpr std::uint32_t infinity = small_float_special << mantissa_bits;
    const std::uint32_t bits = encode_magnitude<mantissa_bits>(value);
    return bits == infinity && value <= std::numeric_limits<real>::max() ? infinity - 1 : bits;
}

}  // namespace aureole::rhi
