// Air that lies low: scale heights of ten metres to a kilometre under a shell of a hundred kilometres, thin and thick.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/worst.h"

#include <aureole/models/single.h>

#include <array>
#include <cmath>

using namespace aureole;
using namespace aureole::physics;

namespace {

Shell shell_of(double scale_height) {
    Shell shell;
    shell.density = [=](Real h) { return std::exp(-h / static_cast<Real>(scale_height)); };
    return shell;
}

AtmosphereParameters fog(double scale_height, const Rgb& scattering, const Rgb& absorption) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(0);
    air.terms = {{"fog", ExponentialProfile{scale_height}, scattering, absorption, HenyeyGreensteinPhase{0.5}}};
    return air;
}

/// Share of a zenith sun's light that is extinguished along a ray from the ground and gets back to the camera: midpoints, dense
/// near the camera, with the column carried along.
double once_scattered(const Shell& shell, double scale_height, double extinction, double mu) {
    const Real length = shell.to_top(0, mu);
    constexpr int steps = 20000;
    Real column = 0, sum = 0;
    for (int i = 0; i < steps; ++i) {
        const Real a = static_cast<Real>(i) / steps, b = static_cast<Real>(i + 1) / steps;
        const Real begin = length * a * a * a, end = length * b * b * b;
        const Real density = shell.density(shell.altitude_after(0, mu, (begin + end) / 2));
        const Real slab = density * (end - begin);
        sum +=
            slab * std::exp(-static_cast<Real>(extinction) * (column + slab / 2 + static_cast<Real>(scale_height) * density));
        column += slab;
    }
    return static_cast<double>(sum) * extinction;
}

SkyOptions of(const QualitySettings& quality) {
    SkyOptions options;
    options.quality = quality;
    return options;
}

}  // namespace

TEST_CASE("fog: the sun's light through it is that of its column, down to scale heights of ten metres") {
    for (const double scale_height : {10.0, 30.0, 100.0, 300.0, 1000.0}) {
        CAPTURE(scale_height);
        const Shell shell = shell_of(scale_height);
        SkyOptions options = of(QualitySettings::standard());
        options.quality.sky_view = {4, 4, 1};
        options.light = true;
        Sky sky(cpu_float(), fog(scale_height, Rgb(0), Rgb(0.2 / scale_height)), options);
        Worst worst;
        for (const double zenith : {0.0, 60.0, 80.0, 87.0}) {
            sky.stand(0, sun_at(zenith * degree));
            const double depth = static_cast<double>(shell.column_to_top(0, std::cos(zenith * degree))) * 0.2 / scale_height;
            worst.add(std::abs(-std::log(sky.light()[9].g) / depth - 1), zenith, depth);
        }
        CHECK_WORST(worst, 1e-2);
    }
}

TEST_CASE("fog: single scattering in it is what quadrature says, up and level, thin and thick") {
    // A thousandth of what is lost is scattered, so that a second scattering does not matter. The sun stands at the zenith.
    for (const double scale_height : {100.0, 300.0, 1200.0})
        for (const double depth : {0.05, 0.3, 1.0, 3.0}) {
            const double extinction = depth / scale_height;
            CAPTURE(scale_height);
            CAPTURE(depth);
            const Shell shell = shell_of(scale_height);
            Sky sky(cpu_float(), fog(scale_height, Rgb(extinction * 1e-3), Rgb(extinction * 0.999)),
                    of(QualitySettings::standard()));
            sky.stand(0, sun_at(0));
            Worst worst;
            for (const double zenith : {0.0, 60.0, 85.0, 89.0, 89.9}) {
                const double expected = once_scattered(shell, scale_height, extinction, std::cos(zenith * degree)) * 1e-3 *
                                        evaluate(HenyeyGreensteinPhase{0.5}, std::cos(zenith * degree));
                worst.add(std::abs(sky.radiance(direction(zenith * degree)).g / expected - 1), zenith, expected);
            }
            // In 32 rows of altitude; the error of the sun's optical depth counts as a part of that depth.
            CHECK_WORST(worst, 0.006 + 0.024 * depth);
        }
}

TEST_CASE("fog filling the shell, from just below its top: single scattering is by the law of Lommel and Seeliger") {
    // A ray down into it is tens to millions of optical depths long; all that is seen comes from the first few.
    for (const double extinction : {1e-3, 1e-2, 0.1}) {
        CAPTURE(extinction);
        AtmosphereParameters air;
        air.planet.ground_albedo = Rgb(0);
        const double below_top = 1 / extinction;
        air.terms = {even_term(Rgb(extinction), Rgb(0), HenyeyGreensteinPhase{0.5})};
        SkyOptions options;
        options.model = models::single({});
        Sky sky(cpu_float(), air, options);
        const double sun = 60 * degree;
        sky.stand(air.planet.top_radius_m - air.planet.bottom_radius_m - below_top, sun_at(sun));
        Worst worst;
        for (const double down : {0.1, 0.3, 1.0, 3.0, 7.0, 20.0, 50.0, 90.0}) {
            const glm::dvec3 eye = direction((90 + down) * degree, 90 * degree);
            const double nu = glm::dot(eye, direction(sun));
            const double mu = std::sin(down * degree), mu_s = std::cos(sun);
            const double expected = evaluate(HenyeyGreensteinPhase{0.5}, nu) * std::exp(-1 / mu_s) * mu_s / (mu_s + mu);
            worst.add(std::abs(sky.radiance(eye).g / expected - 1), down, expected);
        }
        CHECK_WORST(worst, 0.01);
    }
}

TEST_CASE("fog in the shell of a wide planet: a clear, a middling and an opaque channel are each by the law of a layer") {
    // A ray is cut where the air hides what is behind it, but not before the clear channel, which sees all of the layer.
    for (const double thickest : {1e-3, 1e-2, 0.1}) {
        CAPTURE(thickest);
        AtmosphereParameters air;
        air.planet = {.bottom_radius_m = 6e9, .top_radius_m = 6e9 + 1e5};
        air.planet.ground_albedo = Rgb(0);
        const Rgb extinction(1e-6, 3e-5, thickest);
        air.terms = {even_term(extinction, Rgb(0), HenyeyGreensteinPhase{0.5})};
        SkyOptions options;
        options.model = models::single({});
        Sky sky(cpu_float(), air, options);
        const double sun = 60 * degree;
        const double above = 1 / thickest;
        sky.stand(1e5 - above, sun_at(sun));
        Worst worst;
        for (const double down : {5.0, 20.0, 50.0, 90.0}) {
            const glm::dvec3 eye = direction((90 + down) * degree, 90 * degree);
            const double mu = std::sin(down * degree), mu_s = std::cos(sun);
            const double phase = evaluate(HenyeyGreensteinPhase{0.5}, glm::dot(eye, direction(sun)));
            const Rgb seen = sky.radiance(eye);
            for (int c = 0; c < 3; ++c) {
                const double layer = -std::expm1(-extinction[c] * (1e5 - above) * (1 / mu + 1 / mu_s));
                const double expected = phase * std::exp(-extinction[c] * above / mu_s) * mu_s / (mu_s + mu) * layer;
                worst.add(std::abs(seen[c] / expected - 1), down, c);
            }
        }
        CHECK_WORST(worst, 0.01);
    }
}

TEST_CASE("fog: what the sky shows at the horizon is what distant geometry fades into, in every colour") {
    AtmosphereParameters air = presets::earth();
    air.terms.push_back({"fog", ExponentialProfile{100}, Rgb(1e-2), Rgb(0), HenyeyGreensteinPhase{0.7}});
    QualitySettings quality = QualitySettings::standard();
    quality.aerial_perspective = {8, 8, 256};
    quality.aerial_perspective_nodes = 8;
    quality.froxel_format = rhi::Format::rgba32_float;
    Picture picture(cpu_float(), air, quality, 3000);
    Sky sky(cpu_float(), air, of(quality));
    for (const double sun_zenith : {30.0, 80.0}) {
        CAPTURE(sun_zenith);
        const Sun sun = sun_at(sun_zenith * degree);
        Camera camera = look(air.planet.bottom_radius_m, 2, 0, 0.02, 0.02, double{Picture::width} / Picture::height);
        picture.place(camera, {&sun, 1});
        sky.stand(2, sun);
        const std::vector<Rgb> faded = picture.render(3000, Rgb(0));
        Worst worst;
        for (std::uint32_t i = 0; i < faded.size(); i += 17)
            worst.add(apart(sky.radiance(picture.direction(i % Picture::width, i / Picture::width)), faded[i]), i);
        CHECK_WORST(worst, 5e-2);
    }
}

TEST_CASE("half-float froxels: a sun of no light high above changes nothing of the other's twilight") {
    QualitySettings quality = QualitySettings::standard();
    REQUIRE(quality.froxel_format == rhi::Format::rgba16_float);
    const AtmosphereParameters air = presets::earth();
    Picture alone(cpu_float(), air, quality, 96e3, 1), both(cpu_float(), air, quality, 96e3, 2);
    const Camera camera = look(air.planet.bottom_radius_m, 200, 0, 0.1, 0.6, double{Picture::width} / Picture::height);
    Sun dark = sun_at(50 * degree);
    dark.irradiance = Rgb(0);
    for (const double depression : {2.0, 6.0, 8.0, 10.0, 12.0}) {
        CAPTURE(depression);
        const Sun low = sun_at((90 + depression) * degree);
        alone.place(camera, {&low, 1});
        both.place(camera, std::array{dark, low});
        Worst worst;
        for (const double distance : {500.0, 5000.0, 50000.0}) {
            const std::vector<Rgb> a = alone.render(distance, Rgb(0)), b = both.render(distance, Rgb(0));
            for (std::size_t i = 0; i < a.size(); ++i) {
                CHECK(sum(a[i]) > 0);
                worst.add(apart(b[i], a[i]), distance, i);
            }
        }
        CHECK_WORST(worst, 1e-4);
    }
}
