// What formats store, and what shaders read from them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "aureole_rhi_tests_shaders.h"
#include "rhi/checks.h"
#include "rhi/harness.h"
#include "rhi/report.h"

namespace aureole::conformance {

using namespace aureole::rhi;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Floats on both sides of ties, at the ends of ranges, and ordinary ones; four in a texel.
std::vector<Texel> probing_texels() {
    const double tiny = std::ldexp(1.0, -24);  // the smallest half
    return {{0, 1, 0.5, 0.25},
            {1.0 / 3, 2.0 / 3, 0.1, 0.9},
            {1 + std::ldexp(1.0, -11), 1 + std::ldexp(3.0, -11), 1 + std::ldexp(1.0, -7), 1 + std::ldexp(1.0, -6)},
            {1 + std::ldexp(1.0, -12), 1 + std::ldexp(1.0, -10), 0.99951171875, 0.9997558},
            {tiny, 1.5 * tiny, 0.4 * tiny, 700.3 * tiny},
            {6e-5, 6.103515625e-5, 6.2e-5, 1e-4},
            {65504, 65519, 60000.3, 1234.567},
            {-0.25, -1.3, -7.77, 0.7},
            {127.4 / 255, 127.6 / 255, 3.49 / 255, 254.49 / 255},
            {0.0031, 0.00314, 0.02, 0.2}};
}

struct Neighbours {
    double below, above;
};

/// The nearest values that the format holds on both sides of `value` (equal if it holds the value itself).
Neighbours neighbours(Format format, std::size_t channel, double value) {
    const auto rounded = [&](double v) {
        Texel t{};
        t[channel] = v;
        quantize(format, t.data());
        return t[channel];
    };
    // Steps away from the value until rounding gives something on the wanted side.
    const auto search = [&](double direction) {
        double step = std::max(std::abs(value) * 1e-5, 1e-9);
        double v = rounded(value);
        while (direction * (v - value) < 0 && step < 1e9) {
            v = rounded(value + direction * step);
            step *= 1.3;
        }
        return v;
    };
    return {search(-1), search(1)};
}

/// What a store of `value` may read back as.
bool acceptable(Format format, std::size_t channel, double value, double got, bool exact) {
    Texel nearest{value, value, value, value};
    quantize(format, nearest.data());
    if (got == nearest[channel]) return true;
    if (exact || channel >= channel_count(format)) return false;
    if (std::abs(value) < 6.2e-5 && got == 0) return true;  // denormals may vanish
    if (format == Format::rgba8_srgb && channel < 3) {
        // APIs allow 0.6 of a step on the sRGB scale: the neighbouring code.
        Texel packed_texel{got, got, got, 1}, wanted{value, value, value, 1};
        const auto code = [](const Texel& t) { return std::to_integer<int>(pack(Format::rgba8_srgb, {t})[0]); };
        return std::abs(code(packed_texel) - code(wanted)) <= 1;
    }
    const Neighbours n = neighbours(format, channel, value);
    return got == n.below || got == n.above;
}

std::string channel_of(Format format, std::size_t channel) { return std::string(to_string(format)) + "." + "rgba"[channel]; }

void compare(Format format, const std::vector<Texel>& wanted, const std::vector<Texel>& got, bool exact) {
    require(wanted.size() == got.size(), "as many texels come back as were written");
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            if (acceptable(format, c, wanted[i][c], got[i][c], exact)) continue;
            fail(channel_of(format, c) + ": " + print(wanted[i][c]) + " is stored as " + print(got[i][c]));
        }
}

/// As 32-bit floats, which is what reaches the kernel.
std::vector<Texel> as_floats(std::vector<Texel> texels) {
    for (Texel& t : texels) quantize(Format::rgba32_float, t.data());
    return texels;
}

}  // namespace

void check_storage_formats(const Target& target) {
    const auto texels = as_floats(probing_texels());
    const Extent extent{static_cast<std::uint32_t>(texels.size()), 1, 1};
    for (const Format format :
         {Format::r8_unorm, Format::rgba8_unorm, Format::r16_float, Format::rg16_float, Format::rgba16_float, Format::r32_float,
          Format::rg32_float, Format::rgba32_float, Format::r11g11b10_float, Format::bgra8_unorm, Format::rgba8_srgb}) {
        if (!target.device.format_support(format, Dimension::d2).storage) {
            note(std::string("not tried, since it cannot be stored to: ") + to_string(format));
            continue;
        }
        Harness h(target);
        const auto source = h.filled("source", extent, texels);
        const auto image = h.texture("image", format, extent, Usage::storage | Usage::copy_source);
        const auto pipeline = h.compute(shaders::conformance_copy);
        const auto set = h.bind(pipeline, {{0, source, h.sampler(Filter::nearest), {}}, {1, image, {}, {}}});
        h.use(image, State::storage_write);
        h.dispatch(pipeline, set, {(extent.width + 7) / 8, 1, 1});
        compare(format, texels, h.read(image), h.exact);
    }
    // Beyond half's range, and what is no number.
    Harness h(target);
    const auto source = h.filled("source", {1, 1, 1}, {{1e6, -1e6, infinity, std::nan("")}});
    const auto image = h.texture("image", Format::rgba16_float, {1, 1, 1}, Usage::storage | Usage::copy_source);
    const auto pipeline = h.compute(shaders::conformance_copy);
    const auto set = h.bind(pipeline, {{0, source, h.sampler(Filter::nearest), {}}, {1, image, {}, {}}});
    h.use(image, State::storage_write);
    h.dispatch(pipeline, set, {1, 1, 1});
    const Texel got = h.read(image)[0];
    const auto in_half = [](const char* value, double stored) {
        return std::string(value) + " in rgba16_float is stored as " + print(stored);
    };
    expect(got[0] == infinity || (!h.exact && got[0] == 65504), in_half("1e6", got[0]));
    expect(got[1] == -infinity || (!h.exact && got[1] == -65504), in_half("-1e6", got[1]));
    expect(got[2] == infinity, in_half("infinity", got[2]));
    expect(std::isnan(got[3]), in_half("NaN", got[3]));
}

void check_attachment_formats(const Target& target) {
    if (!target.device.capabilities().raster) throw Skipped{"Capabilities::raster is false"};
    const auto texels = as_floats(probing_texels());
    const Extent extent{static_cast<std::uint32_t>(texels.size()), 1, 1};
    for (const Format format : {Format::rgba8_unorm, Format::rgba8_srgb, Format::bgra8_unorm, Format::rgba16_float,
                                Format::rgba32_float, Format::r11g11b10_float}) {
        if (!target.device.format_support(format, Dimension::d2).color_attachment) {
            note(std::string("not tried, since it cannot be drawn to: ") + to_string(format));
            continue;
        }
        Harness h(target);
        const auto canvas = h.filled("canvas", extent, texels);
        const auto image = h.texture("image", format, extent, Usage::color_attachment | Usage::copy_source);
        const auto pipeline = h.raster(shaders::conformance_draw, format);
        const auto set = h.bind(pipeline, {{0, canvas, h.sampler(Filter::nearest), {}}});
        h.use(image, State::color_attachment);
        const float push[8] = {};
        h.list().draw_fullscreen({pipeline, set, bytes_of(push), image});
        compare(format, texels, h.read(image), h.exact);
    }
}

void check_format_reads(const Target& target) {
    // A shader reads what the bytes mean: linear from sRGB, swapped channels, missing channels as 0 and 1.
    const std::vector<Texel> texels = {{0, 1, 0.5, 0.25}, {0.1, 0.2, 0.3, 0.4}, {0.9, 0.01, 0.73, 1}};
    const Extent extent{3, 1, 1};
    for (const Format format :
         {Format::r8_unorm, Format::rgba8_unorm, Format::rgba8_srgb, Format::bgra8_unorm, Format::r16_float, Format::rg16_float,
          Format::rgba16_float, Format::r32_float, Format::rg32_float, Format::r11g11b10_float, Format::d32_float}) {
        if (!target.device.format_support(format, Dimension::d2).sampled) {
            note(std::string("not tried, since it cannot be sampled: ") + to_string(format));
            continue;
        }
        Harness h(target);
        const auto source = h.texture("source", format, extent, Usage::sampled | Usage::copy_destination);
        const auto packed = pack(format, texels);
        h.upload(source, packed);
        h.use(source, format == Format::d32_float ? State::depth_read : State::sampled);
        const auto image = h.texture("image", Format::rgba32_float, extent, Usage::storage | Usage::copy_source);
        const auto pipeline = h.compute(shaders::conformance_copy);
        const auto set = h.bind(pipeline, {{0, source, h.sampler(Filter::nearest), {}}, {1, image, {}, {}}});
        h.use(image, State::storage_write);
        h.dispatch(pipeline, set, {1, 1, 1});
        const auto wanted = unpack(format, packed), got = h.read(image);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            for (std::size_t c = 0; c < 4; ++c) {
                if (format == Format::d32_float && c > 0) continue;  // APIs differ on what stands beside a depth
                const double tolerance = format == Format::rgba8_srgb && !h.exact ? 0.5 / 255 : 1e-6;
                expect_near(channel_of(format, c) + " as a shader reads it", got[i][c], wanted[i][c],
                            tolerance * (1 + std::abs(wanted[i][c])));
            }
    }
}

}  // namespace aureole::conformance
