#include "terrain/height_field.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace aureole::app {
namespace {

constexpr int top_level = 6;                     // 64 cells
constexpr std::int64_t most_points = 1ll << 24;  // of the finer grid, where the map itself has fewer
constexpr int finest = 4;                        // times finer than the map

/// Index in [0, count) of an index that runs through mirror images of a row of `count` cells.
std::int64_t mirror(std::int64_t index, std::int64_t count) {
    if (index >= 0 && index < count) return index;
    const std::int64_t period = 2 * count;
    const std::int64_t i = ((index % period) + period) % period;
    return i < count ? i : period - 1 - i;
}

/// Cells along a side: `factor` times finer than the map's, rounded up to whole cells of the top level.
std::int64_t finer(std::uint32_t points, std::int64_t factor) {
    const std::int64_t cells = (std::int64_t{points} - 1) * factor, block = 1 << top_level;
    return (cells + block - 1) / block * block;
}

/// Catmull & Rom 1974: weights of four neighbours for a place `f` between the middle two.
std::array<double, 4> catmull_rom(double f) {
    return {0.5 * f * (-1 + f * (2 - f)), 0.5 * (2 + f * f * (3 * f - 5)), 0.5 * f * (1 + f * (4 - 3 * f)),
            0.5 * f * f * (f - 1)};
}

void in_parallel(std::int64_t count, const auto& body) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::int64_t>(0, count), [&](const auto& range) {
        for (std::int64_t i = range.begin(); i != range.end(); ++i) body(i);
    });
}

}  // namespace

HeightField::HeightField(const HeightMap& map, double exaggeration) {
    resample(map, exaggeration);
    build_normals();
    build_pyramid();
    build_open_sky();
}

void HeightField::resample(const HeightMap& map, double exaggeration) {
    std::int64_t factor = finest;
    while (factor > 1 && std::int64_t{map.width} * map.height * factor * factor > most_points) --factor;
    nx_ = finer(map.width, factor);
    ny_ = finer(map.height, factor);
    const glm::dvec2 size((map.width - 1) * map.spacing_east_m, (map.height - 1) * map.spacing_north_m);
    cell_ = size / glm::dvec2(static_cast<double>(nx_), static_cast<double>(ny_));
    origin_ = -0.5 * size;

    const auto source = [&](std::int64_t column, std::int64_t row) {  // mirrored about the edge points
        const auto fold = [](std::int64_t i, std::int64_t last) { return std::abs(i) <= last ? std::abs(i) : 2 * last - i; };
        const std::int64_t c = fold(column, map.width - 1), r = fold(row, map.height - 1);
        return static_cast<double>(map.meters[static_cast<std::size_t>(r * map.width + c)]);
    };
    points_.resize(static_cast<std::size_t>((nx_ + 1) * (ny_ + 1)));
    in_parallel(ny_ + 1, [&](std::int64_t y) {
        // The map's rows run from north to south, ours from south to north.
        const double row = static_cast<double>(ny_ - y) * (map.height - 1) / static_cast<double>(ny_);
        const std::int64_t r = std::min(static_cast<std::int64_t>(row), std::int64_t{map.height} - 2);
        const auto wy = catmull_rom(row - static_cast<double>(r));
        for (std::int64_t x = 0; x <= nx_; ++x) {
            const double column = static_cast<double>(x) * (map.width - 1) / static_cast<double>(nx_);
            const std::int64_t c = std::min(static_cast<std::int64_t>(column), std::int64_t{map.width} - 2);
            const auto wx = catmull_rom(column - static_cast<double>(c));
            double sum = 0;
            for (std::int64_t j = 0; j < 4; ++j)
                for (std::int64_t i = 0; i < 4; ++i)
                    sum += wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)] * source(c + i - 1, r + j - 1);
            points_[static_cast<std::size_t>(y * (nx_ + 1) + x)] = static_cast<float>(sum * exaggeration);
        }
    });
    const auto [low, high] = std::ranges::minmax(points_);
    lowest_ = low;
    highest_ = high;
}

void HeightField::build_normals() {
    slopes_.resize(points_.size());
    in_parallel(ny_ + 1, [&](std::int64_t y) {
        for (std::int64_t x = 0; x <= nx_; ++x) {
            // Central differences; at the edges both neighbours are the same point, since the land there is mirrored.
            const auto at = [&](std::int64_t i, std::int64_t j) {
                return static_cast<double>(points_[static_cast<std::size_t>(j * (nx_ + 1) + i)]);
            };
            const double dx = x > 0 && x < nx_ ? (at(x + 1, y) - at(x - 1, y)) / (2 * cell_.x) : 0;
            const double dy = y > 0 && y < ny_ ? (at(x, y + 1) - at(x, y - 1)) / (2 * cell_.y) : 0;
            slopes_[static_cast<std::size_t>(y * (nx_ + 1) + x)] = {static_cast<float>(dx), static_cast<float>(dy)};
        }
    });
}

void HeightField::build_pyramid() {
    pyramid_.resize(top_level + 1);
    for (std::size_t l = 0; l < pyramid_.size(); ++l) {
        Level& level = pyramid_[l];
        level.width = nx_ >> l;
        level.height = ny_ >> l;
        level.ceilings.resize(static_cast<std::size_t>(level.width * level.height));
        // A cell's highest point is one of its corners; a coarse cell's ceiling is the highest of its four.
        const std::vector<float>& below = l == 0 ? points_ : pyramid_[l - 1].ceilings;
        const std::int64_t stride = l == 0 ? nx_ + 1 : pyramid_[l - 1].width, step = l == 0 ? 1 : 2;
        for (std::int64_t y = 0; y < level.height; ++y) {
            for (std::int64_t x = 0; x < level.width; ++x) {
                const float* p = below.data() + y * step * stride + x * step;
                level.ceilings[static_cast<std::size_t>(y * level.width + x)] =
                    std::max({p[0], p[1], p[stride], p[stride + 1]});
            }
        }
    }
}

/// Horizons in 16 directions up to 6 km away, at every grid point of level 2; the cosine-weighted share of a sector of sky
/// above elevation e is cos^2 e.
void HeightField::build_open_sky() {
    constexpr int directions = 16, steps = 24, stride = 4;
    const std::int64_t w = nx_ / stride + 1, h = ny_ / stride + 1;
    open_sky_.resize(static_cast<std::size_t>(w * h));
    in_parallel(h, [&](std::int64_t y) {
        for (std::int64_t x = 0; x < w; ++x) {
            const glm::dvec2 place =
                origin_ + cell_ * glm::dvec2(static_cast<double>(x * stride), static_cast<double>(y * stride));
            const double here = height(place);
            double open = 0;
            for (int d = 0; d < directions; ++d) {
                const double angle = 2 * std::numbers::pi * d / directions;
                const glm::dvec2 towards(std::cos(angle), std::sin(angle));
                double tangent = 0, distance = cell_.x * stride * 0.5;
                for (int s = 0; s < steps && distance < 6000; ++s, distance *= 1.25)
                    tangent = std::max(tangent, (height(place + distance * towards) - here) / distance);
                open += 1 / (1 + tangent * tangent);
            }
            open_sky_[static_cast<std::size_t>(y * w + x)] = static_cast<float>(open / directions);
        }
    });
}

HeightField::Corner HeightField::corner(glm::dvec2 place) const {
    const glm::dvec2 cells = (place - origin_) / cell_;
    const double floor_x = std::floor(cells.x), floor_y = std::floor(cells.y);
    const std::int64_t ix = static_cast<std::int64_t>(floor_x), iy = static_cast<std::int64_t>(floor_y);
    const std::int64_t x = mirror(ix, nx_), y = mirror(iy, ny_);
    // In a mirror image cells run backwards: every other image, counted from the map itself.
    const auto backwards = [](std::int64_t i, std::int64_t n) { return i >= 0 ? i / n % 2 == 1 : (-1 - i) / n % 2 == 0; };
    const bool back_x = backwards(ix, nx_), back_y = backwards(iy, ny_);
    Corner c;
    c.fx = back_x ? 1 - (cells.x - floor_x) : cells.x - floor_x;
    c.fy = back_y ? 1 - (cells.y - floor_y) : cells.y - floor_y;
    c.sign_x = back_x ? -1 : 1;
    c.sign_y = back_y ? -1 : 1;
    c.p00 = static_cast<std::size_t>(y * (nx_ + 1) + x);
    c.p10 = c.p00 + 1;
    c.p01 = c.p00 + static_cast<std::size_t>(nx_ + 1);
    c.p11 = c.p01 + 1;
    return c;
}

double HeightField::height(glm::dvec2 place) const {
    const Corner c = corner(place);
    return std::lerp(std::lerp<double>(points_[c.p00], points_[c.p10], c.fx),
                     std::lerp<double>(points_[c.p01], points_[c.p11], c.fx), c.fy);
}

glm::dvec3 HeightField::normal(glm::dvec2 place) const {
    const Corner c = corner(place);
    const glm::dvec2 south = glm::mix(glm::dvec2(slopes_[c.p00]), glm::dvec2(slopes_[c.p10]), c.fx);
    const glm::dvec2 north = glm::mix(glm::dvec2(slopes_[c.p01]), glm::dvec2(slopes_[c.p11]), c.fx);
    const glm::dvec2 slope = glm::mix(south, north, c.fy) * glm::dvec2(c.sign_x, c.sign_y);
    return glm::normalize(glm::dvec3(-slope.x, -slope.y, 1));
}

double HeightField::open_sky(glm::dvec2 place) const {
    constexpr double stride = 4;
    const Corner c = corner(place);
    const std::int64_t w = nx_ / 4 + 1;
    const std::int64_t column = static_cast<std::int64_t>(c.p00) % (nx_ + 1),
                       row = static_cast<std::int64_t>(c.p00) / (nx_ + 1);
    const double x = (static_cast<double>(column) + c.fx) / stride, y = (static_cast<double>(row) + c.fy) / stride;
    const std::int64_t ix = std::min(static_cast<std::int64_t>(x), w - 2);
    const std::int64_t iy = std::min(static_cast<std::int64_t>(y), ny_ / 4 - 1);
    const float* p = open_sky_.data() + iy * w + ix;
    const double fx = x - static_cast<double>(ix), fy = y - static_cast<double>(iy);
    return std::lerp(std::lerp<double>(p[0], p[1], fx), std::lerp<double>(p[w], p[w + 1], fx), fy);
}

double HeightField::ceiling(int level, std::int64_t x, std::int64_t y) const {
    const Level& l = pyramid_[static_cast<std::size_t>(level)];
    return l.ceilings[static_cast<std::size_t>(mirror(y, l.height) * l.width + mirror(x, l.width))];
}

}  // namespace aureole::app
