// Shadows in the air: lit lengths in closed form, nothing lost where all is lit, multiple scattering alone where all is dark,
// and the same on every backend.
#include <aureole/models/bruneton.h>
#include <aureole/models/hillaire.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>
#include <doctest/doctest.h>

#include "common/rejects.h"
#include "passes/scene.h"
#include "passes/trio.h"
#include "shadows/shadows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent size{5, 5, 1};
constexpr double ground = 6.36e6;

/// Air that is the same everywhere and so thin that nothing is scattered twice, over black ground.
AtmosphereParameters thin_air() {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0);
    air.terms = {{.name = "even",
                  .profile = ExponentialProfile{1e12},
                  .scattering_per_m = Rgb(1e-9),
                  .absorption_per_m = Rgb(0),
                  .phase = RayleighPhase{}}};
    return air;
}

Setup setup_of(const ModelPtr& model, const ShadowSettings& shadows, const AtmosphereParameters& air = thin_air()) {
    Setup setup;
    setup.air = air;
    setup.model = model;
    setup.view.light = false;
    setup.view.aerial_perspective_distance_m = 50e3;
    setup.view.shadows = shadows;
    setup.composite = {.target_format = rhi::Format::rgba32_float, .scene_color = true, .scene_depth = true, .sun_disk = false};
    return setup;
}

Sun overhead() {
    Sun sun;
    sun.direction = {0, 0, 1};
    return sun;
}

/// From above, orthographic: u and v are x and y from (left, left) on, `side` metres across; depth from 20 km of altitude down
/// to -20 km.
glm::dmat4 from_above(double left, double side) {
    glm::dmat4 m(0);
    m[0][0] = m[1][1] = 1 / side;
    m[3][0] = m[3][1] = -left / side;
    m[2][2] = -1 / 40e3;
    m[3][2] = (ground + 20e3) / 40e3;
    m[3][3] = 1;
    return m;
}

/// Cascades side by side, `n` texels each; `depth(cascade, u)` with u of the texel's middle.
template <class Depth>
rhi::Texture map_of(Backend& backend, std::uint32_t cascades, std::uint32_t n, const Depth& depth) {
    Image image{{cascades * n, 4, 1}, {}};
    for (std::uint32_t row = 0; row < 4; ++row)
        for (std::uint32_t x = 0; x < cascades * n; ++x) image.texels.emplace_back(depth(x / n, (x % n + 0.5) / n), 0, 0, 0);
    return backend.make("shadow map", rhi::Format::r32_float, image);
}
constexpr double dark = 0, lit = 1;

/// Geometry at `distance` everywhere, black, seen along +x from 500 m (infinity: the sky, `elevation` up).
Image look_along(Rig& rig, double distance, const Sun& sun, double elevation = 0) {
    const DepthConvention convention{"reversed", look(ground, 500, 0, elevation, 0.05, 1).projection};
    Camera camera = look(ground, 500, 0, elevation, 0.05, 1);
    camera.projection = convention.projection;
    rig.record_view(camera, sun);
    SceneTextures scene = upload(
        rig.backend, size, [&](auto, auto) { return distance; }, convention);
    scene.color = rig.backend.make("black", rhi::Format::rgba32_float, Image{size, std::vector<glm::dvec4>(25, glm::dvec4(0))});
    return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
}
double middle(const Image& image) { return image.at(2, 2).g; }

ShadowSettings fine(std::uint32_t cascades) {
    ShadowSettings settings;
    settings.cascades = cascades;
    settings.size = {8, 8, 32};  // pictures are a few degrees wide
    settings.samples = 16;
    return settings;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("shadows: in thin even air what is left is the lit length, on every model and backend" *
          doctest::test_suite("long")) {
    Backends backends;
    const auto check = [&](Backend& backend, const ModelPtr& model) {
        CAPTURE(backend.name());
        Rig plain(backend, setup_of(model, {})), shadowed(backend, setup_of(model, fine(2)));
        plain.record_air();
        shadowed.record_air();
        // The first cascade: x in [-2, 2] km, dark from 1.5 km on. The second: [-8, 8] km, dark between -1 and 3 km, of which
        // the first one overrules what is nearer than 2 km. Together dark between 1.5 and 3 km.
        ShadowMap map;
        map.texture = map_of(backend, 2, 64, [](std::uint32_t cascade, double u) {
            const double x = cascade == 0 ? -2 + 4 * u : -8 + 16 * u;
            return (cascade == 0 ? x > 1.5 : x > -1 && x < 3) ? dark : lit;
        });
        map.world_to_map = {from_above(-2e3, 4e3), 3.0 * from_above(-8e3, 16e3)};  // any scale of w
        shadowed.view.set_shadow_map(map);
        for (const double distance : {1e3, 2e3, 2.5e3, 4e3, 6e3, 20e3}) {
            CAPTURE(distance);
            // Of even air, 1e-9 per metre, the phase function of molecules at a right angle.
            const double per_m = 1e-9 * 3 / (16 * std::numbers::pi);
            const double loss = per_m * std::clamp(distance - 1.5e3, 0.0, 1.5e3);
            const double all = middle(look_along(plain, distance, overhead()));
            const double left = middle(look_along(shadowed, distance, overhead()));
            CHECK(std::abs(all - left - loss) < 0.008 * per_m * distance);
        }
    };
    const ModelPtr models[] = {models::aureole(small_quality()), models::single_lut({}), models::single({}),
                               models::hillaire({}), model_by_name("bruneton", "low")};
    for (const ModelPtr& model : models) {
        CAPTURE(model->name());
        check(*backends.single, model);
    }
    check(*backends.exact, models[0]);
    if (backends.vulkan)
        for (const ModelPtr& model : {models[0], models[2]}) check(*backends.vulkan, model);
}

TEST_CASE("shadows: depth decides, by its direction and bias") {
    const auto backend = open_cpu_float();
    Rig rig(*backend, setup_of(models::single_lut({}), fine(1)));
    rig.record_air();
    const double all = middle(look_along(rig, 5e3, overhead()));
    CHECK(all > 0);
    // The ray runs at 500 m of altitude, at a depth of 19.5 / 40 (rising by 2 m to 5 km).
    const auto left = [&](double altitude_km, bool reversed, double bias) {
        const double depth = (20 - altitude_km) / 40;
        ShadowMap map;
        map.texture = map_of(*backend, 1, 4, [&](auto, auto) { return reversed ? 1 - depth : depth; });
        map.world_to_map[0] = from_above(-50e3, 100e3);
        if (reversed) {  // 1 - depth
            map.world_to_map[0][2][2] *= -1;
            map.world_to_map[0][3][2] = 1 - map.world_to_map[0][3][2];
        }
        map.reversed = reversed;
        map.bias = bias;
        rig.view.set_shadow_map(map);
        return middle(look_along(rig, 5e3, overhead())) / all;
    };
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        CHECK(left(0.6, reversed, 0) < 2e-3);
        CHECK(left(0.4, reversed, 0) == 1);
        CHECK(left(0.6, reversed, 0.16 / 40) == 1);
        CHECK(left(0.6, reversed, 0.04 / 40) < 2e-3);
    }
    rig.view.set_shadow_map({});
    CHECK(middle(look_along(rig, 5e3, overhead())) == all);
}

TEST_CASE("shadows: where all is lit, every bit is as without them" * doctest::test_suite("long")) {
    Backends backends;
    backends.each([&](Backend& backend) {
        CAPTURE(backend.name());
        const bool quick = backend.name() == backends.single->name();  // the costly models on the quickest one
        std::vector<ModelPtr> models{models::aureole(small_quality()), models::single({})};
        if (quick) models.push_back(models::hillaire({}));
        for (const ModelPtr& made : models) {
            CAPTURE(made->name());
            Rig plain(backend, setup_of(made, {}, presets::earth())),
                shadowed(backend, setup_of(made, fine(1), presets::earth()));
            plain.record_air();
            shadowed.record_air();
            ShadowMap map;
            map.texture = map_of(backend, 1, 4, [](auto, auto) { return lit; });
            map.world_to_map[0] = from_above(-50e3, 100e3);
            for (const bool given : {false, true}) {
                if (given) shadowed.view.set_shadow_map(map);
                for (const double distance : {4e3, infinity})
                    for (const double elevation : {30.0, -2.0})
                        CHECK(look_along(shadowed, distance, sun_at(elevation)) ==
                              look_along(plain, distance, sun_at(elevation)));
            }
        }
    });
}

TEST_CASE("shadows: where all is dark, multiple scattering is left") {
    const auto backend = open_cpu_float();
    ShadowSettings deep = fine(1);
    deep.distance_m = 400e3;
    deep.size.depth = 64;
    const ModelPtr all = models::aureole(QualitySettings::standard()), once = models::single_lut({});
    Rig shadowed(*backend, setup_of(all, deep, presets::earth())), plain(*backend, setup_of(all, {}, presets::earth())),
        single(*backend, setup_of(once, {}, presets::earth())), single_dark(*backend, setup_of(once, deep, presets::earth()));
    QualitySettings first_order;
    first_order.multi_scatter_orders = 0;
    Rig tables_dark(*backend, setup_of(models::aureole(first_order), deep, presets::earth()));
    ShadowMap map;
    map.texture = map_of(*backend, 1, 4, [](auto, auto) { return dark; });
    map.world_to_map[0] = from_above(-1e6, 2e6);
    map.world_to_map[0][2][2] = -1 / 400e3;
    map.world_to_map[0][3][2] = (ground + 200e3) / 400e3;
    for (Rig* rig : {&shadowed, &plain, &single, &single_dark, &tables_dark}) rig->record_air();
    for (Rig* rig : {&shadowed, &single_dark, &tables_dark}) rig->view.set_shadow_map(map);
    for (const double distance : {30e3, infinity}) {
        CAPTURE(distance);
        const Sun sun = sun_at(30);
        const double lit_all = middle(look_along(plain, distance, sun, 0.4)),
                     lit_once = middle(look_along(single, distance, sun, 0.4));
        CHECK(middle(look_along(shadowed, distance, sun, 0.4)) ==
              doctest::Approx(lit_all - lit_once).scale(1e-300).epsilon(0.02));
        CHECK(lit_all - lit_once > 0.1 * lit_all);
        CHECK(middle(look_along(single_dark, distance, sun, 0.4)) < 0.005 * lit_once);
        CHECK(middle(look_along(tables_dark, distance, sun, 0.4)) < 0.02 * lit_once);
    }
}

TEST_CASE("shadows: more samples and slices come closer to a fine march") {
    const auto backend = open_cpu_float();
    const AtmosphereParameters air = presets::earth();
    // Stripes of 250 m at many distances, then the sky beyond them.
    std::vector<double> distances;
    distances.reserve(17);
    for (int i = 0; i < 16; ++i) distances.push_back(400 + 460.0 * i);
    distances.push_back(infinity);
    const auto seen = [&](std::uint32_t slices, std::uint32_t samples) {
        ShadowSettings settings;
        settings.cascades = 1;
        settings.size = {8, 8, slices};
        settings.samples = samples;
        Rig rig(*backend, setup_of(models::single_lut({}), settings, air));
        rig.record_air();
        ShadowMap map;
        map.texture = map_of(*backend, 1, 64, [](auto, double u) { return std::fmod(u * 32, 1) < 0.5 ? dark : lit; });
        map.world_to_map[0] = from_above(0, 16e3);
        rig.view.set_shadow_map(map);
        std::vector<double> values;
        values.reserve(distances.size());
        for (const double distance : distances) values.push_back(middle(look_along(rig, distance, sun_at(60))));
        return values;
    };
    const std::vector<double> truth = seen(256, 64);
    double before = 1;
    for (const auto& [slices, samples] : {std::pair{16u, 1u}, {32u, 1u}, {32u, 4u}, {32u, 16u}, {64u, 4u}, {128u, 4u}}) {
        const std::vector<double> values = seen(slices, samples);
        double worst = 0;
        for (std::size_t i = 0; i + 1 < truth.size(); ++i) worst = std::max(worst, std::abs(values[i] / truth[i] - 1));
        const double sky = std::abs(values.back() / truth.back() - 1);
        std::printf("| shadows | %u slices, %u samples | %.2g %% | sky %.2g %% |\n", slices, samples, 100 * worst, 100 * sky);
        const ShadowSettings defaults;
        if (slices == defaults.size.depth && samples == defaults.samples)
            CHECK(std::max(worst, sky) <= detail::shadows_march_error);  // measured: what plans say of it
        if (slices == 16 || samples == 4) {
            CHECK(worst < before);
            before = worst;
        }
    }
    CHECK(before < 0.01);
}

TEST_CASE("shadows: the same on every backend") {
    Backends backends;
    Precision precision;
    for (const char* preset : {"hazy_earth", "mars", "titan"}) {
        Setup setup = setup_of(nullptr, fine(1), presets::by_name(preset));
        setup.quality.froxel_format = rhi::Format::rgba32_float;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        trio.share_air();
        const double radius = setup.air.planet.bottom_radius_m;
        trio.each([&](Rig& rig) {
            ShadowMap map;
            map.texture = map_of(rig.backend, 1, 8, [](auto, double u) { return std::fmod(u * 4, 1) < 0.5 ? dark : lit; });
            map.world_to_map[0] = from_above(-7.13e3, 16e3);
            map.world_to_map[0][3][2] += (radius - ground) / 40e3;
            rig.view.set_shadow_map(map);
        });
        for (const double elevation : {40.0, 3.0, -3.0}) {
            trio.each([&](Rig& rig) {
                Camera camera = camera_at(setup.air.planet, 200);
                camera.projection = perspective_conventions(1.5).front().projection;
                rig.record_view(camera, sun_at(elevation));
            });
            share_view(trio);
            const auto show = [](Rig& rig) {
                const SceneTextures scene = upload(rig.backend, {20, 12, 1}, patches, perspective_conventions(1.5).front());
                return rig.show({20, 12, 1}, {.scene_color = scene.color, .scene_depth = scene.depth});
            };
            Images images{show(trio.single), show(trio.exact), {}};
            if (trio.vulkan) images.vulkan = show(*trio.vulkan);
            CHECK(images.unsound() == "");
            precision.compare(images, {Measure::Kind::relative, 1e-20, 1e-2}, place_name(preset, 200, elevation));
        }
    }
    // A sample at the edge of a shadow may fall to either side of it.
    precision.check("shadows", "picture", 5e-3, 5e-3);
}

TEST_CASE("shadows: what is out of range is rejected by name") {
    const auto backend = open_cpu_float();
    Atmosphere air(backend->device(), presets::earth(), models::single_lut({}));
    const auto settings = [&](auto change) {
        return detail::rejected_field([&] {
            ViewSettings view;
            view.shadows.cascades = 1;
            change(view.shadows);
            View(air, view, {});
        });
    };
    CHECK(settings([](ShadowSettings& s) { s.cascades = 5; }) == "view.shadows.cascades");
    CHECK(settings([](ShadowSettings& s) { s.distance_m = 0; }) == "view.shadows.distance_m");
    CHECK(settings([](ShadowSettings& s) { s.distance_m = NAN; }) == "view.shadows.distance_m");
    CHECK(settings([](ShadowSettings& s) { s.size.width = 1; }) == "view.shadows.size.width");
    CHECK(settings([](ShadowSettings& s) { s.size.height = 257; }) == "view.shadows.size.height");
    CHECK(settings([](ShadowSettings& s) { s.size.depth = 1; }) == "view.shadows.size.depth");
    CHECK(settings([](ShadowSettings& s) { s.samples = 0; }) == "view.shadows.samples");
    CHECK(settings([](ShadowSettings& s) { s.samples = 65; }) == "view.shadows.samples");
    for (const char* model : {"fog", "reference"}) {
        Atmosphere other(backend->device(), presets::earth(), model_by_name(model, "low"));
        ViewSettings view;
        view.shadows.cascades = 1;
        CHECK_THROWS_WITH_AS(View(other, view, {}), doctest::Contains("view.shadows.cascades"), Error);
    }

    ViewSettings on;
    on.shadows.cascades = 2;
    on.max_suns = 2;
    View view(air, on, {}), off(air, {}, {});
    const auto map = [&](View& of, auto change) {
        return detail::rejected_field([&] {
            ShadowMap given;
            change(given);
            of.set_shadow_map(given);
        });
    };
    CHECK(map(off, [](ShadowMap&) {}) == "shadow_map");
    CHECK(map(view, [](ShadowMap& m) { m.sun = 2; }) == "shadow_map.sun");
    CHECK(map(view, [](ShadowMap& m) { m.bias = -0.1; }) == "shadow_map.bias");
    CHECK(map(view, [](ShadowMap& m) { m.world_to_map[1][2][3] = NAN; }) == "shadow_map.world_to_map[1][2][3]");
    CHECK(map(view, [&](ShadowMap& m) {
              m.texture =
                  backend->make("odd", rhi::Format::r32_float, Image{{3, 1, 1}, std::vector<glm::dvec4>(3, glm::dvec4(0))});
          }) == "shadow_map.texture");
}
