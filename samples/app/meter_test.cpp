#include "app/meter.h"

#include "app/frame.h"

#include <doctest/doctest.h>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace aureole;
using namespace aureole::app;

namespace {

constexpr double pi = std::numbers::pi;

Camera camera(Projection kind, double fov_deg, double aspect) {
    Camera made = look(6e6, 10, 0, 0, fov_deg * pi / 180, aspect);
    made.kind = kind;
    return made;
}

double total(const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); }

}  // namespace

TEST_CASE("solid_angles: pixels of a picture add up to what it shows") {
    CHECK(total(solid_angles(camera(Projection::panorama, 60, 2), 200, 100)) ==
          doctest::Approx(4 * pi).scale(1e-300).epsilon(1e-3));
    CHECK(total(solid_angles(camera(Projection::fisheye, 60, 1.5), 300, 200)) ==
          doctest::Approx(2 * pi).scale(1e-300).epsilon(5e-3));
    // A pyramid with half angles a and b spans 4 asin(sin a sin b) between planes through its apex.
    const double a = pi / 6, b = std::atan(2 * std::tan(a));
    CHECK(total(solid_angles(camera(Projection::matrix, 60, 2), 200, 100)) ==
          doctest::Approx(4 * std::asin(std::sin(a) * std::sin(b))).scale(1e-300).epsilon(1e-3));
}

TEST_CASE("automatic_exposure: the brightest 0.3 sr, or half of the picture, become 0.8") {
    const std::vector<float> pixels{1, 1, 1, 1, 4, 4, 4, 1, 0, 0, 0, 1, 2, 2, 2, 1};
    CHECK(automatic_exposure(pixels, std::vector<double>{1, 1, 1, 1}) == doctest::Approx(0.8 / 4));
    CHECK(automatic_exposure(pixels, std::vector<double>{1, 0.2, 1, 0.1}) ==
          doctest::Approx(0.8 / std::pow(2.0, (0.2 * 2 + 0.1) / 0.3)));
    CHECK(automatic_exposure(pixels, std::vector<double>{1e-4, 1e-4, 0, 1e-4}) == doctest::Approx(0.8 / std::sqrt(8.0)));
    CHECK(automatic_exposure(std::vector<float>(8, 0.0f), std::vector<double>{1, 1}) == 1);
    CHECK(automatic_exposure(std::vector<float>(8, 1e-20f), std::vector<double>{1, 1}) == doctest::Approx(0.8e9));
}

TEST_CASE("automatic exposure: projections of the same scene agree within a stop") {
    const auto backend = open_backend({.name = "cpu"});
    for (const char* name : {"noon", "golden_hour", "twilight", "mars"}) {
        Scene scene = read_scene(std::filesystem::path(AUREOLE_SCENES) / (std::string(name) + ".toml"));
        scene.model.quality = "low";
        const auto exposure = [&](Projection kind) {
            scene.camera.projection = kind;
            FrameOptions options;
            options.width = 192;
            options.height = 108;
            return FrameRenderer(*backend, scene, nullptr, options).render(suns_of(scene)).exposure;
        };
        const double picture = exposure(Projection::matrix);
        CAPTURE(name);
        CAPTURE(picture);
        CHECK(std::abs(std::log2(exposure(Projection::panorama) / picture)) < 1);
        CHECK(std::abs(std::log2(exposure(Projection::fisheye) / picture)) < 1);
    }
}

TEST_CASE("thinned: every so many pixels, and one at least") {
    std::vector<float> rgba;
    for (int i = 0; i < 4 * 6 * 3; ++i) rgba.push_back(static_cast<float>(i));
    const Thinned whole = thinned(rgba, 6, 3, 1), some = thinned(rgba, 6, 3, 4),
                  small = thinned({rgba.data(), 4 * 3 * 2}, 3, 2, 4);
    CHECK(whole.rgba == rgba);
    CHECK(some.width == 2);
    CHECK(some.height == 1);
    CHECK(some.rgba == std::vector<float>{0, 1, 2, 3, 16, 17, 18, 19});
    CHECK(small.width == 1);
    CHECK(small.height == 1);
    CHECK(small.rgba == std::vector<float>{0, 1, 2, 3});
}
