// Packed texels as they lie in buffers and files <-> RGBA numbers. One definition for the CPU backend, for programs that
// read textures back, and for tests.
//
// Rules of all functions, for every format but `undefined`:
//   - Decoding gives RGBA; channels that the format lacks read as 0, alpha as 1. rgba8_srgb decodes to linear values.
//   - Encoding rounds once, to nearest (even on ties): half with denormals, too large values to infinity; r11g11b10 turns
//     negatives into 0 and keeps finite values finite; unorm clamps to [0, 1]; sRGB takes the nearest code on the sRGB scale.
//     NaN stays NaN in float formats and becomes 0 in unorm formats.
//   - Bytes are in the machine's (little-endian) order; texels follow each other without gaps.
#pragma once

#include <aureole/rhi/types.h>

#include <cstddef>
#include <span>

namespace aureole::rhi {

/// One texel. `packed` has bytes_per_texel(format) bytes. Does nothing for Format::undefined.
void decode_texel(Format format, const std::byte* packed, float rgba[4]) noexcept;
void decode_texel(Format format, const std::byte* packed, double rgba[4]) noexcept;
void encode_texel(Format format, const float rgba[4], std::byte* packed) noexcept;   ///< The same, back.
void encode_texel(Format format, const double rgba[4], std::byte* packed) noexcept;  ///< The same, back.

/// Many texels: `rgba` holds four numbers for every texel of `packed`. Throws Error(invalid_argument) if the sizes do not
/// agree or the format is undefined; nothing is written then.
void decode_texels(Format format, std::span<const std::byte> packed, std::span<float> rgba);
void decode_texels(Format format, std::span<const std::byte> packed, std::span<double> rgba);
void encode_texels(Format format, std::span<const float> rgba, std::span<std::byte> packed);   ///< The same, back.
void encode_texels(Format format, std::span<const double> rgba, std::span<std::byte> packed);  ///< The same, back.

/// Rounds one texel to what `format` stores: encodes and decodes it.
void quantize(Format format, float rgba[4]) noexcept;
void quantize(Format format, double rgba[4]) noexcept;
/// Takes a texel to the channels and the range that `format` has, without rounding: what a reference keeps.
void confine(Format format, float rgba[4]) noexcept;
void confine(Format format, double rgba[4]) noexcept;

}  // namespace aureole::rhi
