#include "measure/aerial.h"

#include "io/test_files.h"

#include <aureole/models/aureole.h>
#include <aureole/models/reference.h>
#include <aureole/models/spectral.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/exponential.hpp>
#include <numbers>

using namespace aureole;
using namespace aureole::app;

namespace {

TraceSettings coarse(double error = 1) {
    TraceSettings settings;
    settings.error = error;
    settings.max_paths = 4096;
    return settings;
}

/// Air of the same density everywhere over black ground.
AtmosphereParameters even_air(const Rgb& scattering_per_m, const Rgb& absorption_per_m) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(0);
    DensityTerm term;
    term.name = "even";
    term.profile = ExponentialProfile{1e12};
    term.scattering_per_m = scattering_per_m;
    term.absorption_per_m = absorption_per_m;
    term.phase = RayleighPhase{};
    air.terms.push_back(term);
    return air;
}

/// Zenith's cosine of a pixel's ray, by the angles of a picture 60 degrees high.
double pixel_mu(std::size_t pixel) {
    const std::size_t column = pixel % aerial_width, row = pixel / aerial_width;
    const double x = (static_cast<double>(column) + 0.5) / aerial_width * 2 - 1;
    const double y = 1 - (static_cast<double>(row) + 0.5) / aerial_height * 2;
    const double half = std::tan(std::numbers::pi / 6), wide = half * aerial_width / aerial_height;
    return y * half / std::sqrt(1 + y * y * half * half + x * x * wide * wide);
}

double worst_apart(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[i][c] / b[i][c] - 1));
    return worst;
}

std::vector<Rgb> radiance_of(const AerialTruth& truth) {
    std::vector<Rgb> radiance;
    for (const Estimated& pixel : truth.pixels) radiance.push_back(pixel.radiance);
    return radiance;
}

}  // namespace

TEST_CASE("aerial_distances: spread over the decades, and above the ground") {
    const Planet planet;
    const std::vector<double> high = aerial_distances(planet, {30, 3000, 0});
    std::vector<double> sorted = high;
    std::ranges::sort(sorted);
    REQUIRE(sorted.size() == 96);
    CHECK(sorted.front() > 1);
    CHECK(sorted.back() < 100);
    for (std::size_t i = 0; i < sorted.size(); ++i)
        CHECK(std::abs(std::log10(sorted[i]) / 2 - (static_cast<double>(i) + 0.5) / 96) < 0.02);

    const double bottom = planet.bottom_radius_m / 1000;
    for (const double altitude : {0.0, 0.002, 1.0, 10.0}) {
        const std::vector<double> low = aerial_distances(planet, {30, altitude, 77});
        for (std::size_t i = 0; i < low.size(); ++i) {
            CAPTURE(altitude);
            CAPTURE(i);
            const double mu = pixel_mu(i), r = bottom + altitude;
            const double reaches = std::sqrt(r * r + 2 * r * mu * low[i] + low[i] * low[i]) - bottom;
            CHECK(low[i] <= high[i]);
            CHECK(reaches > -1e-3);
            // Nine tenths down a ray that falls steeply it has a tenth of its altitude left.
            if (low[i] < high[i] && altitude > 0 && mu < -0.3)
                CHECK(reaches == doctest::Approx(altitude / 10).scale(1e-300).epsilon(0.02));
        }
        CHECK(low.front() == high.front());
    }
}

TEST_CASE("aerial: air that only absorbs leaves exp(-distance), by tables and in truth") {
    const auto backend = open_backend({.name = "cpu-double"});
    const Rgb absorption(1e-6, 1e-5, 5e-5);
    const AtmosphereParameters air = even_air(Rgb(0), absorption);
    const AerialView view{50, 5, 20};
    const std::vector<double> distances = aerial_distances(air.planet, view);
    const double own = 0.06 * std::cos(50 * std::numbers::pi / 180);
    CHECK(geometry_radiance(50) == doctest::Approx(own));
    CHECK(geometry_radiance(100) == doctest::Approx(0.0006));
    // As plans say of what they know: of so white ground, in two figures.
    CHECK(geometry_radiance(0) * std::numbers::pi == doctest::Approx(detail::geometry_albedo).epsilon(0.02).scale(1e-300));
    std::vector<Rgb> expected;
    for (const double km : distances) expected.push_back(own * glm::exp(-absorption * km * 1000.0));

    const auto truth = trace_aerial(*backend, air, view, coarse());
    REQUIRE(truth);
    CHECK(truth->reached);
    CHECK(worst_apart(radiance_of(*truth), expected) < 1e-6);
    for (const Estimated& pixel : truth->pixels) CHECK(pixel.error == Rgb(0));
    const auto tables = aerial(*backend, air, models::aureole(QualitySettings::high()), {{view}});
    REQUIRE(tables.size() == 1);
    CHECK(worst_apart(tables[0], expected) < 0.01);
}

TEST_CASE("aerial: thin air adds its own light in proportion to the distance" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu-double"});
    const Rgb scattering(1e-9, 2e-9, 3e-9);
    const AtmosphereParameters air = even_air(scattering, Rgb(0));
    const AerialView view{0, 5, 0};
    const double own = static_cast<float>(geometry_radiance(0));  // as a texture holds it
    const std::vector<double> distances = aerial_distances(air.planet, view);
    const auto truth = trace_aerial(*backend, air, view, coarse());
    REQUIRE(truth);
    const auto one = open_backend({.name = "cpu-double", .threads = 1});
    const auto alone = trace_aerial(*one, air, view, coarse());
    REQUIRE(alone);
    CHECK(radiance_of(*alone) == radiance_of(*truth));
    for (std::size_t i = 0; i < distances.size(); ++i) {
        CHECK(truth->pixels[i].error.g > 0);
        CAPTURE(i);
        const double nu = pixel_mu(i);  // the sun is overhead
        const Rgb depth = scattering * distances[i] * 1000.0;
        const Rgb added = depth * (3 / (16 * std::numbers::pi) * (1 + nu * nu));
        const Rgb found = truth->pixels[i].radiance - own * glm::exp(-depth);
        for (int c = 0; c < 3; ++c)  // light scattered twice, and air before the sun: as much as the depth of all the air
            CHECK(std::abs(found[c] - added[c]) < 0.002 * added[c]);
    }
}

TEST_CASE("aerial: out of the air nothing comes between") {
    const auto backend = open_backend({.name = "cpu-double"});
    const std::vector<AerialView> views{{30, 36000, 0}, {120, 36000, 0}};
    const auto pictures = aerial(*backend, presets::earth(), models::aureole(QualitySettings::low()), views);
    REQUIRE(pictures.size() == 2);
    for (const Rgb& pixel : pictures[0]) CHECK(pixel.g == doctest::Approx(geometry_radiance(30)));
    for (const Rgb& pixel : pictures[1]) CHECK(pixel.g == doctest::Approx(0.0006));
    CHECK(aerial(*backend, presets::earth(), models::aureole(QualitySettings::low()), {}).empty());
}

TEST_CASE("aerial: a day on Earth by tables is the truth within both errors" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu-double"});
    const AtmosphereParameters air = presets::earth();
    const AerialView view{60, 1, 60};
    double share = 0;
    const auto truth = trace_aerial(*backend, air, view, coarse(0.012), [&](double now) { share = now; });
    REQUIRE(truth);
    CHECK(truth->reached);
    CHECK(share == 1);
    const auto tables = aerial(*backend, air, models::aureole(QualitySettings::high()), {{view}});
    double apart = 0, noise = 0, squares = 0, worst = 0, air_share = 0;
    for (std::size_t i = 0; i < aerial_pixels; ++i)
        for (int c = 0; c < 3; ++c) {
            const Estimated& pixel = truth->pixels[i];
            CHECK(truth->paths[i] >= 1024);
            CHECK(pixel.error[c] <= 0.012 * pixel.radiance[c]);
            const double off = std::abs(tables[0][i][c] / pixel.radiance[c] - 1);
            apart += off / 288;
            squares += std::pow((tables[0][i][c] - pixel.radiance[c]) / pixel.error[c], 2) / 288;
            noise += pixel.error[c] / pixel.radiance[c] / 288;
            worst = std::max(worst, off);
            air_share = std::max(air_share, std::abs(pixel.radiance[c] / geometry_radiance(60) - 1));
        }
    std::printf(
        "aerial: tables are %.2f %% from the truth on average, worst %.2f %%; standard error %.2f %%, rms %.2f of them\n",
        100 * apart, 100 * worst, 100 * noise, std::sqrt(squares));
    CHECK(air_share > 0.5);
    CHECK(apart < 0.005);
    CHECK(worst < 0.03);

    // Not closer than the noise, and not much farther.
    CHECK(std::sqrt(squares) > 0.7);
    CHECK(std::sqrt(squares) < 2);
}

TEST_CASE("aerial: truth in wavelengths, against tables in wavelengths" * doctest::test_suite("long")) {
    const auto backend = open_backend({.name = "cpu-double"});
    const AtmosphereParameters air = presets::earth();
    const AerialView view{60, 1, 60};
    TraceSettings settings = coarse();
    settings.spectral = "3";
    const auto truth = trace_aerial(*backend, air, view, settings);
    REQUIRE(truth);
    const auto in_rgb = aerial(*backend, air, models::aureole(QualitySettings::standard()), {{view}});
    const ModelPtr model =
        models::spectral(models::aureole(QualitySettings::standard()), {.wavelengths = models::wavelengths_by_name("3")});
    const auto tables = aerial(*backend, air, model, {{view}});
    const std::vector<Rgb> radiance = radiance_of(*truth);
    CHECK(worst_apart(tables[0], radiance) < 0.05);
    CHECK(worst_apart(in_rgb[0], radiance) > 0.05);
}

TEST_CASE("aerial: stopped, and refused") {
    const auto backend = open_backend({.name = "cpu"});
    const AtmosphereParameters air = presets::earth();
    int asked = 0;
    CHECK_FALSE(trace_aerial(*backend, air, {60, 1, 0}, coarse(), {}, [&] { return ++asked > 2; }));
    CHECK(asked == 3);
    const auto says = [&](const AerialView& view) {
        const std::vector<AerialView> views{{30, 0, 0}, view};
        return complaint([&] { (void)aerial(*backend, air, models::aureole(QualitySettings::low()), views); });
    };
    CHECK(contains(says({190, 0, 0}), "view 2: sun_zenith_deg: 190"));
    CHECK(contains(says({30, -11, 0}), "view 2: altitude_km: -11"));
    CHECK(contains(says({30, 0, std::nan("")}), "view 2: azimuth_deg"));
    CHECK(says({30, -1, 0}) == "nothing");
    const auto trace_says = [&](const TraceSettings& settings) {
        return complaint([&] { (void)trace_aerial(*backend, air, {}, settings); });
    };
    TraceSettings orders = coarse();
    orders.orders = 2;
    CHECK(contains(trace_says(orders), "orders: 2"));
    CHECK(contains(trace_says(coarse(0)), "error: 0"));
}
