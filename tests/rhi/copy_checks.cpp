// Bytes through copies.
#include "rhi/checks.h"
#include "rhi/harness.h"
#include "rhi/report.h"

namespace aureole::conformance {

using namespace aureole::rhi;

namespace {

constexpr Format all_formats[] = {Format::r8_unorm,   Format::rgba8_unorm,  Format::rgba8_srgb,      Format::bgra8_unorm,
                                  Format::r16_float,  Format::rg16_float,   Format::rgba16_float,    Format::r32_float,
                                  Format::rg32_float, Format::rgba32_float, Format::r11g11b10_float, Format::d32_float};

/// Different everywhere, inside [0, 1] so that every format holds it, and not only round numbers.
std::vector<std::byte> pattern(Format format, std::size_t texels) {
    std::vector<Texel> values(texels);
    for (std::size_t i = 0; i < texels; ++i) {
        const double x = (static_cast<double>(i) + 0.3) / static_cast<double>(texels);
        values[i] = {x, 1 - x, x * x, 0.5 * x + 0.1};
    }
    return pack(format, values);
}

void expect_equal_bytes(const std::string& what, const std::vector<std::byte>& got, const std::vector<std::byte>& wanted) {
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = wanted.size(); i-- > 0;)
        if (i >= got.size() || got[i] != wanted[i]) ++wrong, first = i;
    expect(wrong == 0, what + ": " + std::to_string(wrong) + " of " + std::to_string(wanted.size()) +
                           " bytes come back as others, number " + std::to_string(first) + " first");
}

void check_round_trip(const Target& target, Format format, Extent extent, Dimension dimension) {
    const std::string what = std::string(to_string(format)) + ", " + to_string(dimension);
    if (!target.device.format_support(format, dimension).sampled) return note("not tried, since it cannot be sampled: " + what);
    Harness h(target);
    const std::size_t faces = dimension == Dimension::cube ? 6 : 1;
    const auto bytes = pattern(format, faces * extent.width * extent.height * extent.depth);
    const auto texture =
        h.texture("round trip", format, extent, Usage::sampled | Usage::copy_source | Usage::copy_destination, dimension);
    h.upload(texture, bytes);
    expect_equal_bytes(what, h.read_packed(texture), bytes);
}

}  // namespace

void check_texel_round_trips(const Target& target) {
    for (const Format format : all_formats) {
        check_round_trip(target, format, {13, 7, 1}, Dimension::d2);  // odd sizes: rows are packed without gaps
        if (format == Format::d32_float) continue;
        check_round_trip(target, format, {5, 3, 4}, Dimension::d3);
    }
}

void check_cube_copies(const Target& target) {
    check_round_trip(target, Format::rgba16_float, {5, 5, 1}, Dimension::cube);
    check_round_trip(target, Format::rgba8_unorm, {4, 4, 1}, Dimension::cube);
}

void check_texture_copies(const Target& target) {
    for (const Dimension dimension : {Dimension::d2, Dimension::d3, Dimension::cube}) {
        Harness h(target);
        const Extent extent{6, 6, dimension == Dimension::d3 ? 3u : 1u};
        const auto bytes = pattern(Format::rgba16_float, dimension == Dimension::d2   ? 36
                                                         : dimension == Dimension::d3 ? 108
                                                                                      : 216);
        const Usage usage = Usage::sampled | Usage::copy_source | Usage::copy_destination;
        const auto first = h.texture("first", Format::rgba16_float, extent, usage, dimension);
        const auto second = h.texture("second", Format::rgba16_float, extent, usage, dimension);
        h.upload(first, bytes);
        h.use(first, State::copy_source);
        h.use(second, State::copy_destination);
        h.list().copy(TextureToTexture{first, second});
        expect_equal_bytes(std::string("texture to texture, ") + to_string(dimension), h.read_packed(second), bytes);
    }
}

}  // namespace aureole::conformance
