#include "viewer/core/difference.h"

#include "common/luminance.h"

#include <aureole/rhi/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace aureole::viewer {
namespace {

constexpr double darkest_share = 1e-3;

double luminance(const float* rgb) { return app::luminance(Rgb(rgb[0], rgb[1], rgb[2])); }

template <class Image>
void check_sizes(const Image& a, const Image& b) {
    if (a.width == b.width && a.height == b.height) return;
    const auto size = [](const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); };
    throw Error(ErrorCode::invalid_argument, "picture B", size(b), size(a) + ", as picture A");
}

double quantile(std::vector<float>& sorted, double share) {
    return sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

Difference difference(const app::LinearImage& a, const app::LinearImage& b) {
    check_sizes(a, b);
    Difference result{a.width, a.height, {}};
    const std::size_t pixels = std::size_t{a.width} * a.height;
    double mean = 0;
    for (std::size_t i = 0; i < pixels; ++i) mean += luminance(a.rgb.data() + 3 * i) / static_cast<double>(pixels);
    result.relative.reserve(pixels);
    std::vector<float> absolute;
    absolute.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const double of_a = luminance(a.rgb.data() + 3 * i), apart = luminance(b.rgb.data() + 3 * i) - of_a;
        const double by = std::max(of_a, darkest_share * mean);
        // Beyond any range where there is no telling: nothing to compare with, or no number.
        const double share = apart == 0 ? 0 : by > 0 && std::isfinite(apart) ? apart / by : 1e9;
        result.relative.push_back(static_cast<float>(share));
        absolute.push_back(static_cast<float>(std::abs(share)));
    }
    std::ranges::sort(absolute);
    result.median = quantile(absolute, 0.5);
    result.p95 = quantile(absolute, 0.95);
    result.greatest = quantile(absolute, 1);
    return result;
}

std::array<std::uint8_t, 3> false_colour(double relative, double range) {
    const double t = 3 * std::sqrt(std::min(std::abs(relative) / range, 1.0));
    const auto step = [&](double from) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(t - from, 0.0, 1.0))); };
    return relative >= 0 ? std::array{step(0), step(1), step(2)} : std::array{step(2), step(1), step(0)};
}

app::DisplayImage false_colours(const Difference& difference, double range) {
    app::DisplayImage image{difference.width, difference.height, {}};
    image.rgb.reserve(3 * difference.relative.size());
    for (const float relative : difference.relative)
        for (const std::uint8_t value : false_colour(relative, range)) image.rgb.push_back(value);
    return image;
}

app::DisplayImage split(const app::DisplayImage& a, const app::DisplayImage& b, double divider) {
    check_sizes(a, b);
    app::DisplayImage image = a;
    const auto at = static_cast<std::uint32_t>(std::lround(std::clamp(divider, 0.0, 1.0) * a.width));
    for (std::uint32_t y = 0; y < a.height; ++y) {
        const std::size_t row = std::size_t{3} * y * a.width;
        const auto from = static_cast<std::ptrdiff_t>(row + std::size_t{3} * at);
        const auto to = static_cast<std::ptrdiff_t>(row + std::size_t{3} * a.width);
        std::copy(b.rgb.begin() + from, b.rgb.begin() + to, image.rgb.begin() + from);
        if (at > 0 && at < a.width) std::fill_n(image.rgb.begin() + from, 3, std::uint8_t{255});
    }
    return image;
}

}  // namespace aureole::viewer
