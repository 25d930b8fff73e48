// The model hillaire: what its tables and pictures hold by its equations, on every backend alike, and its settings.
#include <doctest/doctest.h>

#include <aureole/models/hillaire.h>

#include "common/rejects.h"
#include "models/hillaire/plain_2020_test.h"
#include "passes/trio.h"

#include <functional>

using namespace aureole;
using namespace aureole::passes;

namespace {

models::HillaireSettings exact(models::HillaireSettings settings) {
    settings.table_format = settings.froxel_format = rhi::Format::rgba32_float;
    return settings;
}

/// Odd shapes, so that no side is a multiple of a workgroup's.
models::HillaireSettings small() {
    models::HillaireSettings settings = exact({});
    settings.transmittance = {40, 12, 1};
    settings.multi_scatter = {9, 7, 1};
    settings.sky_view = {11, 22, 1};
    settings.aerial_perspective = {9, 7, 6};
    return settings;
}

Setup setup_of(const char* preset, const models::HillaireSettings& settings) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = models::hillaire(settings);
    setup.view.light = false;
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.composite.scene_depth = setup.composite.sun_disk = false;
    return setup;
}

double apart(const glm::dvec4& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(glm::dvec3(a) - b);
    return (d.x + d.y + d.z) / (b.x + b.y + b.z);
}

}  // namespace

TEST_CASE("hillaire: the transmittance table by its equation") {
    const auto cpu = open_cpu_double();
    const Setup setup = setup_of("earth", small());
    AirRig rig(*cpu, setup);
    rig.record_air();
    const Image table = rig.transmittance();
    const plain_2020::Air plain{setup.air};
    const double top = std::sqrt(plain.top() * plain.top() - plain.bottom() * plain.bottom());
    for (std::uint32_t y = 0; y + 1 < table.extent.height; ++y) {
        const double rho = top * y / (table.extent.height - 1), r = std::hypot(plain.bottom(), rho);
        for (std::uint32_t x = 0; x < table.extent.width; ++x) {
            const double least = plain.top() - r, d = least + x * (rho + top - least) / (table.extent.width - 1);
            const double mu = std::clamp((top * top - rho * rho - d * d) / (2 * r * d), -1.0, 1.0);
            const glm::dvec3 depth = plain.optical_depth({0, 0, r}, {std::sqrt(1 - mu * mu), 0, mu});
            CAPTURE(x);
            CAPTURE(y);
            CHECK(apart(table.at(x, y), depth) < 1e-5);
        }
    }
}

TEST_CASE("hillaire: the multi-scatter table by its equations") {
    const auto cpu = open_cpu_double();
    for (const char* preset : {"earth", "mars"}) {
        models::HillaireSettings settings = exact({});
        settings.multi_scatter = {9, 7, 1};
        const Setup setup = setup_of(preset, settings);
        AirRig rig(*cpu, setup);
        rig.record_air();
        const Image table = rig.multi_scatter();
        const plain_2020::Air plain{setup.air};
        std::vector<double> errors;
        for (std::uint32_t y = 0; y < 7; ++y)
            for (std::uint32_t x = 4; x < 9; ++x) {  // from the horizon up
                const double r = plain.bottom() + (plain.top() - plain.bottom()) * y / 6.0;
                // The ends touch the ground's and the top's spheres, where a ray of the plain code meets them or not.
                const double inside = std::clamp(r, plain.bottom() + 1, plain.top() - 1);
                errors.push_back(apart(table.at(x, y), plain.psi(inside, std::max(x / 4.0 - 1, 1e-6))));
            }
        std::sort(errors.begin(), errors.end());
        CAPTURE(preset);
        CHECK(errors[errors.size() / 2] < 5e-5);
        CHECK(errors.back() < 1e-3);  // of the look-ups of the transmittance table
    }
}

TEST_CASE("hillaire: a sky marched for each pixel, by its equations") {
    const auto cpu = open_cpu_double();
    models::HillaireSettings settings = exact(models::HillaireSettings::high());
    settings.march_steps = 12;
    const Setup setup = setup_of("earth", settings);
    Rig rig(*cpu, setup);
    rig.record_air();
    const plain_2020::Air plain{setup.air};
    const Image directions{{3, 2, 1},
                           {{0, 0, 1, 0},
                            {0.6, 0, 0.8, 0},
                            {-0.8, 0, 0.6, 0},
                            {0, 0.96, 0.28, 0},
                            {0.9, 0.3, 0.3162277660, 0},
                            {-0.99, 0, 0.1410673598, 0}}};
    CompositeTargets targets;
    targets.directions = cpu->make("directions", rhi::Format::rgba32_float, directions);
    for (const auto& place : {std::pair(500.0, 50.0), {500.0, 8.0}, {8000.0, 20.0}}) {
        const auto& altitude = place.first;
        const auto& elevation = place.second;
        rig.record_view(camera_at(setup.air.planet, altitude), sun_at(elevation));
        const Image shown = rig.show(directions.extent, targets);
        for (std::uint32_t i = 0; i < 6; ++i) {
            const glm::dvec3 d = glm::normalize(glm::dvec3(directions.texels[i]));
            const glm::dvec3 expected =
                plain.sky({0, 0, plain.bottom() + altitude}, d, glm::dvec3(sun_at(elevation).direction), settings.march_steps);
            CAPTURE(altitude);
            CAPTURE(elevation);
            CAPTURE(i);
            const double error = apart(shown.texels[i], expected);
            CHECK(error < 0.01);  // of the look-ups
        }
    }
}

TEST_CASE("hillaire: tables show what a march shows, as far as they resolve it") {
    const auto cpu = open_cpu_float();
    models::HillaireSettings fast, marched = models::HillaireSettings::high();
    Setup of_fast = setup_of("earth", fast), of_march = setup_of("earth", marched);
    Rig a(*cpu, of_fast), b(*cpu, of_march);
    a.record_air();
    b.record_air();
    CHECK(!b.view.sky_view_table());
    CHECK(!b.view.aerial_perspective_table());
    for (const double elevation : {40.0, 3.0}) {
        const Camera camera = camera_at(of_fast.air.planet, 200);
        a.record_view(camera, sun_at(elevation));
        b.record_view(camera, sun_at(elevation));
        const Image one = a.show({24, 16, 1}), other = b.show({24, 16, 1});
        Worst worst;
        worst.compare(one, other, {});
        INFO(worst.text());
        CHECK(worst.error() < 0.05);
    }
}

TEST_CASE("hillaire: grey transmittance is the mean of the colours'") {
    const auto cpu = open_cpu_float();
    models::HillaireSettings grey = small(), rgb = small();
    rgb.grey_transmittance = false;
    Rig a(*cpu, setup_of("hazy_earth", grey)), b(*cpu, setup_of("hazy_earth", rgb));
    for (Rig* rig : {&a, &b}) {
        rig->record_air();
        rig->record_view(camera_at(rig->setup.air.planet, 100), sun_at(20));
    }
    const Image one = a.froxels(), other = b.froxels();
    const std::uint32_t rows = grey.aerial_perspective.height;
    REQUIRE(one.extent.height == 2 * rows);  // optical depth, radiance
    for (std::uint32_t z = 0; z < one.extent.depth; ++z)
        for (std::uint32_t y = 0; y < rows; ++y)
            for (std::uint32_t x = 0; x < one.extent.width; ++x) {
                const glm::dvec3 depth(one.at(x, y, z)), colours = glm::exp(-glm::dvec3(other.at(x, y, z)));
                CHECK(depth.x == depth.y);
                CHECK(depth.x == depth.z);
                CHECK(std::exp(-depth.x) ==
                      doctest::Approx((colours.x + colours.y + colours.z) / 3).scale(1e-300).epsilon(1e-5));
                CHECK(one.at(x, y + rows, z) == other.at(x, y + rows, z));
            }
}

TEST_CASE("hillaire: every backend makes the same tables and pictures, at all altitudes and hours") {
    Backends backends;
    Precision sky, froxels, marched;
    // Dark is what is a thousandth of the picture.
    constexpr Measure by_layer{.kind = Measure::Kind::relative, .least = 1e-6, .least_of_largest = 1e-3};
    // From space some froxels' rays graze the top of the air: their length is a difference of large numbers.
    constexpr Measure grazing{.kind = Measure::Kind::relative, .least = 1e-4, .least_of_largest = 1e-3};
    for (const char* preset : preset_names()) {
        models::HillaireSettings direct = small();
        direct.fast_sky = direct.fast_aerial_perspective = false;
        Trio<Rig> tables(backends, setup_of(preset, small())), marching(backends, setup_of(preset, direct));
        for (Trio<Rig>* trio : {&tables, &marching}) {
            trio->record_air();
            trio->share_air();
        }
        const Planet& planet = tables.single.setup.air.planet;
        for (const double altitude : {0.0, 2.0, 1e4, 3e5})
            for (const double elevation : {90.0, 5.0, 0.0, -4.0}) {
                const std::string where = place_name(preset, altitude, elevation);
                for (Trio<Rig>* trio : {&tables, &marching})
                    trio->each([&](Rig& rig) { rig.record_view(camera_at(planet, altitude), sun_at(elevation)); });
                for (const auto& [images, worst] :
                     {std::pair(tables.read(&Rig::sky_view), &sky), {tables.read(&Rig::froxels), &froxels}}) {
                    CHECK_MESSAGE(images.unsound() == "", where);
                    worst->compare(images, worst == &froxels ? grazing : by_layer, where);
                }
                Images shown{marching.single.show({9, 7, 1}), marching.exact.show({9, 7, 1}), {}};
                if (marching.vulkan) shown.vulkan = marching.vulkan->show({9, 7, 1});
                CHECK_MESSAGE(shown.unsound() == "", where);
                marched.compare(shown, by_layer, where);
            }
    }
    // In double a step that lies on the edge of the planet's shadow may be lit and in float not: one of the 30.
    sky.check("hillaire", "sky-view", 1e-4, 3e-2);
    froxels.check("hillaire", "froxels", 5e-3, 5e-3);
    marched.check("hillaire", "marched picture", 1e-4, 1e-3);
}

TEST_CASE("hillaire: the published setting, and the phone's") {
    const models::HillaireSettings s;
    CHECK(s.transmittance == rhi::Extent{256, 64, 1});
    CHECK(s.transmittance_steps == 40);
    CHECK(s.multi_scatter == rhi::Extent{32, 32, 1});
    CHECK(s.multi_scatter_steps == 20);
    CHECK(s.sky_view == rhi::Extent{200, 100, 1});
    CHECK(s.sky_view_steps == 30);
    CHECK(s.aerial_perspective == rhi::Extent{32, 32, 32});
    const models::HillaireSettings phone = models::HillaireSettings::by_name("low");
    CHECK(phone.sky_view == rhi::Extent{96, 50, 1});
    CHECK(phone.sky_view_steps == 8);
    CHECK(phone.aerial_perspective == rhi::Extent{32, 32, 16});
    CHECK(detail::rejected_field([] { (void)models::HillaireSettings::by_name("ultra"); }) == "quality");
}

TEST_CASE("hillaire: settings out of range are named") {
    using S = models::HillaireSettings;
    const std::pair<const char*, std::function<void(S&)>> faults[] = {
        {"hillaire.transmittance.width", [](S& s) { s.transmittance.width = 1; }},
        {"hillaire.transmittance_steps", [](S& s) { s.transmittance_steps = 0; }},
        {"hillaire.multi_scatter.height", [](S& s) { s.multi_scatter.height = 257; }},
        {"hillaire.multi_scatter_steps", [](S& s) { s.multi_scatter_steps = 4097; }},
        {"hillaire.sky_view.height", [](S& s) { s.sky_view.height = 51; }},
        {"hillaire.sky_view_steps", [](S& s) { s.sky_view_steps = -1; }},
        {"hillaire.aerial_perspective.depth", [](S& s) { s.aerial_perspective.depth = 1; }},
        {"hillaire.march_steps", [](S& s) { s.march_steps = 5000; }},
        {"hillaire.table_format", [](S& s) { s.table_format = rhi::Format::rgba8_unorm; }},
        {"hillaire.froxel_format", [](S& s) { s.froxel_format = rhi::Format::undefined; }}};
    for (const auto& [field, spoil] : faults) {
        S settings;
        spoil(settings);
        CHECK(detail::rejected_field([&] { (void)models::hillaire(settings); }) == field);
    }
}
