// What eight bits make of a slow sunset: bands that stand and jump, and what the dither makes of them.
#include "passes/rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent extent{32, 128, 1};
constexpr std::uint32_t block = 8;  // side of a patch whose mean is looked at, pixels
constexpr double degree = std::numbers::pi / 180;

CompositeSettings composite(rhi::Format format, bool dither) {
    return {.target_format = format,
            .sun_disk = false,
            .exposure = 6,
            .tone_map = ToneMap::aces_fitted,
            .encode_srgb = true,
            .dither = dither};
}

/// 128 rows of 3 degrees of sky, across from the sun: a step of eight bits is dozens of pixels.
Camera camera() {
    return look(presets::earth().planet.bottom_radius_m, 2, 150 * degree, 25 * degree, 3 * degree,
                static_cast<double>(extent.width) / extent.height);
}

/// The frames of one target, in steps of eight bits.
class Shown {
public:
    Shown(Backend& backend, rhi::Format format, bool dither) : rig_(backend, setup(format, dither)) { rig_.record_air(); }
    std::vector<double> frame(std::uint64_t number, double sun_elevation_deg) {
        rig_.air.set_frame(number);
        rig_.record_view(camera(), sun_at(sun_elevation_deg));
        std::vector<double> green;
        for (const glm::dvec4& texel : rig_.show(extent).texels) green.push_back(255 * texel.g);
        return green;
    }

private:
    static Setup setup(rhi::Format format, bool dither) {
        Setup setup;
        setup.quality = QualitySettings::low();
        setup.view.aerial_perspective = false;
        setup.view.light = false;
        setup.composite = composite(format, dither);
        return setup;
    }
    Rig rig_;
};

/// Means of patches.
std::vector<double> patches(const std::vector<double>& pixels) {
    std::vector<double> means;
    for (std::uint32_t y = 0; y + block <= extent.height; y += block)
        for (std::uint32_t x = 0; x + block <= extent.width; x += block) {
            double sum = 0;
            for (std::uint32_t j = 0; j < block; ++j)
                for (std::uint32_t i = 0; i < block; ++i) sum += pixels[(y + j) * extent.width + x + i];
            means.push_back(sum / (block * block));
        }
    return means;
}

/// Rows in a column that show the same.
int longest_run(const std::vector<double>& pixels) {
    int longest = 0;
    for (std::uint32_t x = 0; x < extent.width; ++x) {
        int run = 0;
        for (std::uint32_t y = 0; y < extent.height; ++y) {
            const bool same = y > 0 && pixels[y * extent.width + x] == pixels[(y - 1) * extent.width + x];
            run = same ? run + 1 : 1;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}
std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

/// In steps of eight bits, of all frames; errors are against the same frame unrounded.
struct Found {
    int run = 0;         ///< Rows of one value.
    double pixel = 0;    ///< Error of a pixel.
    double band = 0;     ///< Error of a patch's mean: what is seen as a band.
    double flicker = 0;  ///< By how much that differs from one frame to the next.
    double slow = 0;     ///< Of the scene itself: how much a patch changes from one frame to the next.
};

Found watch(Backend& backend, bool dither) {
    Shown exact(backend, rhi::Format::rgba32_float, false), shown(backend, rhi::Format::rgba8_unorm, dither);
    Found found;
    std::vector<double> error_before, scene_before;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const double elevation_deg = 4 - 0.01 * static_cast<double>(i);  // two and a half seconds a frame
        const std::vector<double> truth = exact.frame(i, elevation_deg), seen = shown.frame(i, elevation_deg);
        const std::vector<double> scene = patches(truth), error = patches(minus(seen, truth));
        found.run = std::max(found.run, longest_run(seen));
        found.pixel = std::max(found.pixel, largest_difference(seen, truth));
        found.band = std::max(found.band, largest_difference(patches(seen), scene));
        if (i > 0) {
            found.flicker = std::max(found.flicker, largest_difference(error, error_before));
            found.slow = std::max(found.slow, largest_difference(scene, scene_before));
        }
        error_before = error;
        scene_before = scene;
    }
    return found;
}

}  // namespace

TEST_CASE("stability, eight bits: dithered, a sunset has no bands, and its patches change as the scene does") {
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        const Found plain = watch(*backend, false), dithered = watch(*backend, true);
        if (std::getenv("AUREOLE_STABILITY_PRINT") != nullptr)
            for (const Found* f : {&plain, &dithered})
                std::printf("%s, %s: run %d, pixel %.3f, band %.3f, flicker %.3f, scene %.3f\n", backend->name().c_str(),
                            f == &plain ? "plain" : "dithered", f->run, f->pixel, f->band, f->flicker, f->slow);
        // What is rounded is off by half a step; at the edge of a band of 38 rows, so are 8 of them, less 4 / 38.
        CHECK(plain.pixel <= 0.501);
        CHECK(plain.band > 0.3);
        // Of triangular noise between -1 and 1, and rounding, the error is even in [-1.5, 1.5] and its variance 1/4 whatever
        // the value: the mean of 64 pixels is within 1/4, four standard deviations, and differs between two frames by sqrt(2)
        // times that.
        CHECK(dithered.pixel <= 1.501);
        CHECK(dithered.band <= 0.25);
        CHECK(dithered.flicker <= 0.36);
        CHECK(dithered.run < plain.run);
        CHECK(dithered.band < plain.band / 2);
    }
}
