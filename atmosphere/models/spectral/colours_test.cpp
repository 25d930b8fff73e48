// How far the colours of a few wavelengths, and of red, green and blue, are from those of forty.
#include <doctest/doctest.h>

#include <aureole/models/hillaire.h>
#include <aureole/models/spectral.h>

#include "passes/rig.h"

#include <algorithm>
#include <cstdio>

using namespace aureole;
using namespace aureole::passes;
using spectrum::Wavelengths;

namespace {

constexpr rhi::Extent all_around{24, 14, 1};
constexpr std::uint32_t sky_rows = 7;

/// The upper half of the panorama, in cd/m^2.
std::vector<Rgb> sky(Rig& rig, double elevation, const Rgb& irradiance) {
    Camera camera = camera_at(rig.setup.air.planet, 2);
    camera.kind = Projection::panorama;
    Sun sun = sun_at(elevation);
    sun.irradiance = irradiance;
    rig.record_view(camera, sun);
    const Image image = rig.show(all_around);
    std::vector<Rgb> result;
    for (std::uint32_t y = 0; y < sky_rows; ++y)
        for (std::uint32_t x = 0; x < all_around.width; ++x) result.emplace_back(image.at(x, y));
    return result;
}

Setup setup_of(const ModelPtr& model, const AtmosphereParameters& air) {
    Setup setup;
    setup.air = air;
    setup.model = model;
    setup.view.projection = Projection::panorama;
    setup.view.light = setup.view.aerial_perspective = setup.composite.sun_disk = false;
    setup.composite.target_format = rhi::Format::rgba32_float;
    return setup;
}

struct Spread {
    double mean = 0, p95 = 0, worst = 0;
};

/// CIEDE2000, with each colour of `truth` exposed to half the luminance of white.
Spread differences(const std::vector<Rgb>& colours, const std::vector<Rgb>& truth) {
    std::vector<double> all;
    const glm::dvec3 white = spectrum::white_d65();
    Spread spread;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double exposure = 0.5 / spectrum::xyz_from_rec709(truth[i]).y;
        const auto lab = [&](const Rgb& colour) {
            return spectrum::lab_from_xyz(spectrum::xyz_from_rec709(colour * exposure), white);
        };
        all.push_back(spectrum::delta_e_2000(lab(colours[i]), lab(truth[i])));
        spread.mean += all.back() / static_cast<double>(truth.size());
    }
    std::ranges::sort(all);
    spread.p95 = all[all.size() * 95 / 100];
    spread.worst = all.back();
    return spread;
}

struct Mode {
    const char* name;
    int wavelengths;   ///< 0: rgb.
    double mean, p95;  ///< Bounds, of any hour.
};

void compare(Backend& backend, const ModelPtr& inner, std::span<const double> elevations, std::span<const Mode> modes) {
    const AtmosphereParameters air = presets::earth();
    const auto named = [](int count) { return models::wavelengths_by_name(std::to_string(count)); };
    const Wavelengths forty = named(40);
    const Rgb sun = models::solar_rec709(forty);
    Rig truth(backend, setup_of(models::spectral(inner, {forty}), air));
    truth.record_air();
    std::vector<std::vector<Rgb>> expected;
    for (const double elevation : elevations) expected.push_back(sky(truth, elevation, sun));
    for (const Mode& mode : modes) {
        const bool rgb = mode.wavelengths == 0;
        Rig rig(backend, setup_of(rgb ? inner : models::spectral(inner, {named(mode.wavelengths)}), air));
        rig.record_air();
        const Rgb light = rgb ? sun : models::solar_rec709(named(mode.wavelengths));
        std::printf("| %s | %s |", std::string(inner->name()).c_str(), mode.name);
        for (std::size_t i = 0; i < elevations.size(); ++i) {
            const Spread d = differences(sky(rig, elevations[i], light), expected[i]);
            std::printf(" %.3f, %.3f, %.3f |", d.mean, d.p95, d.worst);
            INFO(mode.name << ", sun at " << elevations[i]);
            CHECK(d.mean < mode.mean);
            CHECK(d.p95 < mode.p95);
        }
        std::printf("\n");
    }
}

}  // namespace

TEST_CASE("spectral: colours of a few wavelengths against those of forty") {
    const auto cpu = open_cpu_float();
    constexpr double elevations[] = {60, 5, 0, -4};
    constexpr Mode modes[] = {{"rgb", 0, 22, 40}, {"3", 3, 2, 3}, {"4", 4, 0.25, 0.4}, {"6", 6, 0.2, 0.4}, {"12", 12, 0.8, 2}};
    compare(*cpu, models::aureole(), elevations, modes);
    constexpr double dusk[] = {60, -4};
    models::HillaireSettings settings;
    settings.table_format = rhi::Format::rgba32_float;
    settings.sky_view = {24, 64, 1};
    compare(*cpu, models::hillaire(settings), dusk, std::span(modes).subspan(2, 2));
}
