#include "passes/scene.h"

#include <cmath>
#include <limits>

namespace aureole::passes {
namespace {

constexpr double near_m = 10, far_m = 2e5;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Clip z = a z + b of view-space z = -distance; clip w = -z (perspective) or 1 (orthographic).
glm::dmat4 projection(double aspect, bool parallel, double a, double b) {
    const double focal = parallel ? 1e-3 : 1.8;
    glm::dmat4 p(0);
    p[0][0] = focal / aspect;
    p[1][1] = focal;
    p[2][2] = a;
    p[3][2] = b;
    p[2][3] = parallel ? 0 : -1;
    p[3][3] = parallel ? 1 : 0;
    return p;
}

}  // namespace

double patches(std::uint32_t x, std::uint32_t y) {
    constexpr double distances[] = {20, 400, 3e3, infinity, 15e3, 80e3, 7e3};
    return distances[(x / 5 + 3 * (y / 4)) % 7];
}

double DepthConvention::stored(double distance_m) const {
    // At infinity: the limit, which is that of the coefficients of z where clip w grows too.
    const double z = -distance_m;
    const double w = projection[2][3] * z + projection[3][3];
    const bool parallel = projection[2][3] == 0;
    double ndc = (projection[2][2] * z + projection[3][2]) / w;
    // Beyond a finite far plane nothing is drawn: the buffer holds what it was cleared to, the far plane's depth.
    const bool infinite = !parallel && (projection[2][2] == 0 || projection[2][2] == -1);
    if (!infinite && distance_m > far_m) return stored(far_m);
    if (infinite && std::isinf(distance_m)) ndc = -projection[2][2];
    return range == DepthRange::zero_to_one ? ndc : 0.5 * (ndc + 1);
}

std::vector<DepthConvention> perspective_conventions(double aspect) {
    const double n = near_m, f = far_m, d = f - n;
    const auto p = [&](double a, double b) { return projection(aspect, false, a, b); };
    return {{"reversed infinite", p(0, n)},
            {"reversed", p(n / d, n * f / d)},
            {"forward", p(-f / d, -n * f / d)},
            {"forward infinite", p(-1, -n)},
            {"forward, -1 to 1", p(-(f + n) / d, -2 * n * f / d), DepthRange::minus_one_to_one},
            {"forward infinite, -1 to 1", p(-1, -2 * n), DepthRange::minus_one_to_one},
            {"reversed, -1 to 1", p((f + n) / d, 2 * n * f / d), DepthRange::minus_one_to_one}};
}

std::vector<DepthConvention> orthographic_conventions(double aspect) {
    const double n = near_m, f = far_m, d = f - n;
    const auto p = [&](double a, double b) { return projection(aspect, true, a, b); };
    return {{"orthographic reversed", p(1 / d, f / d)},
            {"orthographic forward", p(-1 / d, -n / d)},
            {"orthographic forward, -1 to 1", p(-2 / d, -(f + n) / d), DepthRange::minus_one_to_one}};
}

SceneTextures upload(Backend& backend, rhi::Extent extent, const Landscape& landscape, const DepthConvention& convention,
                     RowOrder order, rhi::Format depth_format) {
    Image color{extent, {}}, depth{extent, {}};
    for (std::uint32_t row = 0; row < extent.height; ++row) {
        const std::uint32_t y = order == RowOrder::top_first ? row : extent.height - 1 - row;
        for (std::uint32_t x = 0; x < extent.width; ++x) {
            const double distance = landscape(x, y);
            depth.texels.emplace_back(convention.stored(distance), 0, 0, 1);
            // Behind holes stand stars: dark, so that they do not outshine the sky.
            const double shine = std::isinf(distance) ? 1e-3 : 0.2;
            color.texels.emplace_back(shine * (1 + x % 3), shine * (1 + y % 2), 0.7 * shine, 1);
        }
    }
    return {backend.make("scene color", rhi::Format::rgba32_float, color), backend.make("scene depth", depth_format, depth)};
}

}  // namespace aureole::passes
