#include "app/meter.h"

#include "common/luminance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace aureole::app {
namespace {

constexpr double metered_sr = 0.3;
constexpr double bright = 0.8;
/// Luminance below which automatic exposure does not go on brightening: nights stay dark.
constexpr double darkest = 1e-9;
constexpr double pi = std::numbers::pi;

}  // namespace

std::vector<double> solid_angles(const Camera& camera, std::uint32_t width, std::uint32_t height) {
    const double smaller = std::min(width, height);
    const double wide = 1 / camera.projection[0][0], high = 1 / camera.projection[1][1];  // half the picture at distance 1
    const auto of_pixel = [&](double x, double y) {                                       // from the middle, in [-1, 1]
        switch (camera.kind) {
            case Projection::panorama:
                return std::cos(y * pi / 2) * (2 * pi / width) * (pi / height);
            case Projection::fisheye: {
                const double z = std::hypot(x * width, y * height) / smaller * pi / 2;
                return z < pi / 2 ? (z > 0 ? std::sin(z) / z : 1) * (pi / smaller) * (pi / smaller) : 0;
            }
            case Projection::matrix:
                break;
        }
        const double area = 4 * wide * high / width / height;
        return area * std::pow(1 + x * x * wide * wide + y * y * high * high, -1.5);
    };
    std::vector<double> all;
    all.reserve(std::size_t{width} * height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            all.push_back(of_pixel(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1));
    return all;
}

Thinned thinned(std::span<const float> rgba, std::uint32_t width, std::uint32_t height, std::uint32_t step) {
    Thinned some{(width + step - 1) / step, (height + step - 1) / step, {}};
    for (std::size_t y = 0; y < height; y += step)
        for (std::size_t x = 0; x < width; x += step) {
            const auto pixel = rgba.subspan(4 * (y * width + x), 4);
            some.rgba.insert(some.rgba.end(), pixel.begin(), pixel.end());
        }
    return some;
}

double automatic_exposure(std::span<const float> rgba, std::span<const double> solid_angles) {
    std::vector<std::pair<double, double>> pixels;  // luminance, solid angle
    double seen = 0;
    for (std::size_t i = 0; i < solid_angles.size(); ++i) {
        const float* p = rgba.data() + 4 * i;
        const double light = luminance(Rgb(p[0], p[1], p[2]));
        if (!(light > 0) || solid_angles[i] == 0) continue;
        pixels.emplace_back(std::max(light, darkest), solid_angles[i]);
        seen += solid_angles[i];
    }
    std::ranges::sort(pixels, std::greater());
    const double wanted = std::min(metered_sr, seen / 2);
    double sum = 0, measured = 0;
    for (const auto& [luminance, solid_angle] : pixels) {
        sum += solid_angle * std::log(luminance);
        measured += solid_angle;
        if (measured >= wanted) break;
    }
    return measured == 0 ? 1 : bright / std::exp(sum / measured);
}

}  // namespace aureole::app
