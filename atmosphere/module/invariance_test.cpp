// What must not matter, and what must: axes, units, threads, the order of suns, the last centimetre above the ground.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "passes/compare.h"
#include "passes/scene.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent size{33, 21, 1};
constexpr Measure radiance{Measure::Kind::relative, 0, 1e-4};
const Planet earth = presets::earth().planet;

Setup setup_of(Projection kind = Projection::panorama, std::uint32_t suns = 1) {
    Setup setup;
    setup.quality.sky_view = {16, 48, 1};
    setup.view.projection = kind;
    setup.view.max_suns = suns;
    setup.composite.target_format = rhi::Format::rgba32_float;
    return setup;
}

/// All around from an altitude, the centre of the picture towards +x, where the sun is.
Camera panorama(double altitude_m, const Planet& planet = earth) {
    Camera camera = look(planet.bottom_radius_m, altitude_m, 0, 0, 1, 1);
    camera.kind = Projection::panorama;
    return camera;
}

Image show(Rig& rig, const Camera& camera, std::span<const Sun> suns) {
    rig.record_view(camera, suns);
    return rig.show(size);
}
Image show(Rig& rig, const Camera& camera, const Sun& sun) { return show(rig, camera, std::span(&sun, 1)); }

double sum_of(const Image& image) {
    double sum = 0;
    for (const glm::dvec4& t : image.texels) sum += t.x + t.y + t.z;
    return sum;
}

void check_same(const Image& a, const Image& b, double bound, const std::string& where = {}) {
    Worst worst;
    worst.compare(a, b, radiance, where);
    INFO(worst.text());
    CHECK(worst.error() <= bound);
}

/// Calls `check` with a fresh rig on each backend.
template <class Check>
void on_every_backend(const Setup& setup, const Check& check) {
    for (const auto& backend : {open_cpu_float(), open_cpu_double(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        Rig rig(*backend, setup);
        rig.record_air();
        check(rig);
    }
}

}  // namespace

TEST_CASE("invariance: two suns shine as the sum of each alone, in any order") {
    on_every_backend(setup_of(Projection::matrix, 2), [](Rig& rig) {
        const Camera camera = camera_at(earth, 500);
        Sun suns[] = {sun_at(40), sun_at(3)};
        suns[0].irradiance = {1, 0.5, 0.25};
        suns[1].direction = {std::cos(0.7) * 0.9, std::sin(0.7) * 0.9, 0.05};
        const Image both = show(rig, camera, suns);
        const Image first = show(rig, camera, suns[0]), second = show(rig, camera, suns[1]);
        Image sum = first;
        for (std::size_t i = 0; i < sum.texels.size(); ++i) sum.texels[i] += second.texels[i];
        check_same(both, sum, 1e-5);
        std::swap(suns[0], suns[1]);
        check_same(show(rig, camera, suns), both, 1e-5);
        CHECK(sum_of(show(rig, camera, std::span<const Sun>())) == 0);
    });
}

TEST_CASE("invariance: a camera below the ground sees what one on the ground sees") {
    on_every_backend(setup_of(), [](Rig& rig) {
        for (const double elevation : {50.0, 1.0, -4.0}) {
            const Image on_ground = show(rig, panorama(0), sun_at(elevation));
            for (const double altitude : {-1e-6, -0.01, -10.0, -5e3})
                check_same(show(rig, panorama(altitude), sun_at(elevation)), on_ground, 1e-5, std::to_string(altitude));
        }
    });
}

TEST_CASE("invariance: the ground itself is lit, as a centimetre and two metres above it are") {
    on_every_backend(setup_of(), [](Rig& rig) {
        for (const double elevation : {50.0, 5.0, -4.0}) {
            INFO(elevation);
            const double at_zero = sum_of(show(rig, panorama(0), sun_at(elevation)));
            CHECK(at_zero > 0);
            CHECK(sum_of(show(rig, panorama(0.01), sun_at(elevation))) == doctest::Approx(at_zero).scale(1e-300).epsilon(2e-3));
            CHECK(sum_of(show(rig, panorama(2), sun_at(elevation))) == doctest::Approx(at_zero).scale(1e-300).epsilon(0.01));
        }
        // Every direction has light by day, the bare ground below the horizon too.
        for (const glm::dvec4& texel : show(rig, panorama(0), sun_at(50)).texels)
            for (int channel = 0; channel < 3; ++channel) CHECK(texel[channel] > 1e-4);
    });
}

TEST_CASE("invariance: from the ground to space without a hitch, and space is black") {
    Setup setup = setup_of();
    setup.quality.sky_view = QualitySettings::standard().sky_view;
    on_every_backend(setup, [](Rig& rig) {
        const double top = earth.top_radius_m - earth.bottom_radius_m;
        for (const double elevation : {50.0, 5.0, -4.0}) {
            const Sun sun = sun_at(elevation);
            INFO(elevation);
            CHECK(sum_of(show(rig, panorama(top + 1), sun)) ==
                  doctest::Approx(sum_of(show(rig, panorama(top - 1), sun))).scale(1e-300).epsilon(0.002));
        }
        for (const double altitude : {4e5, 1e6, 5e6}) {
            Sun sun = sun_at(50);
            sun.angular_radius_rad = 0;
            const Image picture = show(rig, panorama(altitude), sun);
            CHECK(sum_of(picture) > 0.1);  // the planet below
            for (std::uint32_t x = 0; x < size.width; ++x) {
                for (std::uint32_t y = 0; y <= size.height / 2; ++y)  // up to the horizontal there is nothing
                    CHECK(glm::dvec3(picture.at(x, y)) == glm::dvec3(0));
                CHECK(picture.at(x, size.height - 1).z > 1e-3);
            }
        }
    });
}

TEST_CASE("invariance: left and right of the sun look alike") {
    on_every_backend(setup_of(), [](Rig& rig) {
        for (const double altitude : {0.0, 2.0, 3e4, 4e5}) {
            for (const double elevation : {60.0, 2.0, -3.0}) {
                const Image picture = show(rig, panorama(altitude), sun_at(elevation));
                Image mirrored{size, {}};
                for (std::uint32_t y = 0; y < size.height; ++y)
                    for (std::uint32_t x = size.width; x-- > 0;) mirrored.texels.push_back(picture.at(x, y));
                check_same(picture, mirrored, 1e-4, std::to_string(altitude) + " m, " + std::to_string(elevation));
            }
        }
    });
}

TEST_CASE("invariance: no axis is up: planet, camera and suns turned together show the same") {
    Setup setup = setup_of(Projection::matrix);
    setup.composite.scene_color = setup.composite.scene_depth = true;
    on_every_backend(setup, [](Rig& rig) {
        const DepthConvention depth = perspective_conventions(33.0 / 21.0).front();
        const SceneTextures scene = upload(rig.backend, size, patches, depth);
        const CompositeTargets targets{.scene_color = scene.color, .scene_depth = scene.depth};
        for (const double altitude : {0.0, 1e3, 4e5}) {
            Camera camera = camera_at(earth, altitude);
            camera.projection = depth.projection;
            const Sun sun = sun_at(7);
            rig.record_view(camera, sun);
            const Image reference = rig.show(size, targets);
            for (const auto& [angle, axis] : {std::pair(1.0, glm::dvec3(1, 2, 3)),
                                              {std::numbers::pi / 2, glm::dvec3(1, 0, 0)},
                                              {std::numbers::pi, glm::dvec3(0, 1, 0)}}) {
                const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, glm::normalize(axis));
                Camera turned = camera;
                turned.position_m = glm::dvec3(turn * glm::dvec4(camera.position_m, 0));
                turned.view = camera.view * glm::transpose(turn);
                Sun turned_sun = sun;
                turned_sun.direction = glm::dvec3(turn * glm::dvec4(sun.direction, 0));
                rig.record_view(turned, turned_sun);
                check_same(rig.show(size, targets), reference, 1e-4, std::to_string(altitude));
            }
        }
    });
}

TEST_CASE("invariance: a planet a thousand times smaller with air a thousand times denser looks the same") {
    constexpr double scale = 1e-3;
    Setup small = setup_of();
    small.air.planet.bottom_radius_m *= scale;
    small.air.planet.top_radius_m *= scale;
    for (DensityTerm& term : small.air.terms) {
        term.scattering_per_m /= scale;
        term.absorption_per_m /= scale;
        if (auto* layer = std::get_if<ExponentialProfile>(&term.profile)) layer->scale_height_m *= scale;
        if (auto* layer = std::get_if<TentProfile>(&term.profile))
            *layer = {layer->center_m * scale, layer->half_width_m * scale};
    }
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        Rig full(*backend, setup_of()), reduced(*backend, small);
        full.record_air();
        reduced.record_air();
        for (const double altitude : {0.0, 10.0, 5e3, 4e5}) {
            for (const double elevation : {60.0, 2.0, -4.0}) {
                check_same(show(reduced, panorama(altitude * scale, small.air.planet), sun_at(elevation)),
                           show(full, panorama(altitude), sun_at(elevation)), 1e-3,
                           std::to_string(altitude) + " m, " + std::to_string(elevation));
            }
        }
    }
}

TEST_CASE("invariance: results do not depend on the number of threads") {
    std::vector<Image> reference;
    for (const unsigned threads : {1U, 2U, 3U, 0U}) {
        const auto cpu = open_cpu_float(threads);
        Rig rig(*cpu, setup_of(Projection::matrix));
        rig.record_air();
        rig.record_view(camera_at(earth, 1e3), sun_at(4));
        const std::vector<Image> all = {rig.transmittance(), rig.multi_scatter(), rig.sky_view(),
                                        rig.froxels(),       rig.light(),         rig.show(size)};
        if (reference.empty()) reference = all;
        CHECK(all == reference);
    }
}
