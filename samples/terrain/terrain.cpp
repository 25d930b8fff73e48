#include "terrain/terrain.h"

#include "terrain/noise.h"
#include "terrain/pixel_rays.h"

#include <aureole/light.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace aureole::app {
namespace {

double smooth(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Height of the roughness that the grid, which knows nothing below its spacing, leaves out: for the light alone, in [0, 1],
/// 0.5 on average, fading with distance.
double relief(glm::dvec2 place, double footprint_m) { return fractal_noise(place, 60, footprint_m, 7); }

glm::dvec3 roughen(glm::dvec3 normal, glm::dvec2 place, double footprint_m) {
    constexpr double strength = 10;  // metres of height
    const double delta = std::clamp(footprint_m, 0.25, 2.0);
    const auto bump = [&](glm::dvec2 p) { return strength * relief(p, footprint_m); };
    const double here = bump(place);
    const glm::dvec2 slope((bump(place + glm::dvec2(delta, 0)) - here) / delta,
                           (bump(place + glm::dvec2(0, delta)) - here) / delta);
    return glm::normalize(glm::dvec3(normal.x - slope.x * normal.z, normal.y - slope.y * normal.z, normal.z));
}

/// Of the sky's light, what reaches rough ground: less in a hollow of the relief than on a hump of it, and less between steep
/// flanks. 1 where the relief has faded.
double open_relief(glm::dvec2 place, const glm::dvec3& smooth_normal, const glm::dvec3& rough_normal, double footprint_m) {
    const double cosine = glm::dot(smooth_normal, rough_normal), squared = cosine * cosine;
    return (0.3 + 1.4 * relief(place, footprint_m)) * (0.1 + 0.9 * squared * squared);
}

struct Shading {
    const HeightField& field;
    const RayCaster& caster;
    const TerrainLight& light;
    const TerrainLook& look;

    [[nodiscard]] bool in_shadow(const glm::dvec3& point, const glm::dvec3& sun) const {
        const double start = field.cell_size(0).x;
        const glm::dvec3 lifted = point + glm::normalize(point) * 2.0;
        return caster.cast(lifted, sun, start, look.range_m).has_value();
    }

    [[nodiscard]] Rgb radiance(glm::dvec2 place, double footprint_m) const {
        const double height = field.height(place);
        const glm::dvec3 point = caster.point_at(place, height);
        const glm::dvec3 smooth_normal = field.normal(place);
        const glm::dvec3 rough_normal = roughen(smooth_normal, place, footprint_m);
        const glm::dvec3 normal = caster.to_world(point, rough_normal);
        const double between = std::clamp((height - light.low_m) / (light.high_m - light.low_m), 0.0, 1.0);
        const double open = field.open_sky(place);
        const double in_relief = open_relief(place, smooth_normal, rough_normal, footprint_m);

        Rgb irradiance(0), on_the_flat(0);
        for (std::size_t s = 0; s < light.low.size(); ++s) {
            const LightRow &low = light.low[s], &high = light.high[s];
            const glm::dvec3& direction = light.sun_directions[s];
            const glm::dvec3 up = glm::normalize(point);
            const double cosine = glm::dot(normal, direction);
            const Rgb sun = glm::mix(low.sun, high.sun, between);
            irradiance +=
                open * in_relief * glm::mix(sky_irradiance(low.sky, normal), sky_irradiance(high.sky, normal), between);
            on_the_flat += glm::mix(sky_irradiance(low.sky, up), sky_irradiance(high.sky, up), between) +
                           sun * std::max(glm::dot(up, direction), 0.0);
            if (cosine > 0 && sun.r + sun.g + sun.b > 0 && !in_shadow(point, direction)) irradiance += sun * cosine;
        }
        // What the land hides of the sky it replaces by its own light: once reflected, by ground as bright as flat ground.
        const Rgb around = look.albedo.value_or(Rgb(0.07, 0.08, 0.04));
        irradiance += (1 - open) * around * on_the_flat;
        const Rgb albedo = look.albedo.value_or(natural_albedo(place, height, smooth_normal, footprint_m));
        return albedo * std::numbers::inv_pi * irradiance;
    }
};

}  // namespace

Rgb natural_albedo(glm::dvec2 place, double height_m, const glm::dvec3& normal, double footprint_m) {
    const Rgb meadow(0.105, 0.125, 0.045), straw(0.20, 0.165, 0.085), forest(0.032, 0.047, 0.017), rock(0.21, 0.19, 0.165);
    const double steepness = 1 - normal.z;  // 0 flat, 0.29 at 45 degrees
    const double patches = fractal_noise(place, 420, footprint_m, 9);
    const double stands = fractal_noise(place + glm::dvec2(5000, 0), 1600, footprint_m, 10);
    const double crowns = fractal_noise(place, 13, footprint_m, 4);
    const double tufts = 0.5 * fractal_noise(place - glm::dvec2(3000, 0), 90, footprint_m, 7) +
                         0.5 * fractal_noise(place - glm::dvec2(7000, 0), 15, footprint_m, 4);

    const Rgb fields = glm::mix(meadow, straw, smooth(0.42, 0.62, patches)) * (0.2 + 1.6 * tufts);
    const Rgb trees = forest * (0.75 + 0.5 * patches) * (0.55 + 0.9 * crowns);
    // Woods on slopes and heights, fields in the flat.
    const double wooded = smooth(0.006, 0.03, steepness + 0.04 * (stands - 0.5)) * 0.85 + 0.15 * smooth(400, 700, height_m);
    const Rgb ground = glm::mix(fields, trees, smooth(0.3, 0.7, wooded + 0.6 * (stands - 0.5) + 1.6 * (tufts - 0.5)));
    return glm::mix(ground, rock * (0.7 + 0.6 * patches), smooth(0.16, 0.30, steepness + 0.08 * (patches - 0.5)));
}

TerrainPicture cast_terrain(const HeightField& field, const RayCaster& caster, const Camera& camera, const TerrainLight& light,
                            const TerrainLook& look, std::uint32_t width, std::uint32_t height) {
    const PixelRays rays(camera, width, height);
    const Shading shading{field, caster, light, look};
    const double pixel_angle = 2 * rays.half_height / height;

    TerrainPicture picture{width, height, {}, {}};
    picture.rgba.resize(std::size_t{4} * width * height);
    picture.depth.resize(std::size_t{width} * height);
    struct Row {
        std::size_t land = 0;
        double nearest = 1e30, farthest = 0;
    };
    std::vector<Row> rows(height);
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::uint32_t>(0, height), [&](const auto& range) {
        for (std::uint32_t y = range.begin(); y != range.end(); ++y) {
            for (std::uint32_t x = 0; x < width; ++x) {
                const glm::dvec3 in_view = rays.in_view(x, y);
                const auto hit = caster.cast(camera.position_m, rays.to_world * in_view, 0, look.range_m);
                if (!hit) continue;
                const std::size_t i = std::size_t{y} * width + x;
                const Rgb color = shading.radiance(hit->place, hit->distance_m * pixel_angle);
                for (std::size_t c = 0; c < 3; ++c) picture.rgba[4 * i + c] = static_cast<float>(color[static_cast<int>(c)]);
                picture.rgba[4 * i + 3] = 1;
                picture.depth[i] = static_cast<float>(depth_value(camera.projection, -in_view.z * hit->distance_m));
                ++rows[y].land;
                rows[y].nearest = std::min(rows[y].nearest, hit->distance_m);
                rows[y].farthest = std::max(rows[y].farthest, hit->distance_m);
            }
        }
    });
    std::size_t land = 0;
    picture.nearest_m = 1e30;
    for (const Row& row : rows) {
        land += row.land;
        picture.nearest_m = std::min(picture.nearest_m, row.nearest);
        picture.farthest_m = std::max(picture.farthest_m, row.farthest);
    }
    picture.covered = static_cast<double>(land) / static_cast<double>(picture.depth.size());
    return picture;
}

}  // namespace aureole::app
