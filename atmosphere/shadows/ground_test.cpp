// Shadows on the bare ground that the library draws: in closed form where there is hardly any air, the sky's light alone where
// the sun's beam is gone, the map that was set last, on every model and backend.
#include <aureole/models/hillaire.h>
#include <aureole/models/single.h>
#include <aureole/models/single_lut.h>
#include <doctest/doctest.h>

#include "passes/trio.h"

#include <cmath>
#include <numbers>
#include <span>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr double ground = 6.36e6;
constexpr rhi::Extent size{16, 2, 1};

Setup setup_of(const ModelPtr& model, bool shadowed, const AtmosphereParameters& air) {
    Setup setup;
    setup.air = air;
    setup.model = model;
    setup.quality.sky_view = {64, 128, 1};  // of the ground it keeps what its rows are apart
    setup.view.light = false;
    if (shadowed) setup.view.shadows = {.cascades = 2, .distance_m = 50e3, .size = {8, 8, 32}};
    setup.composite = {.target_format = rhi::Format::rgba32_float, .sun_disk = false};
    return setup;
}

AtmosphereParameters hardly_any_air() {
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = {0.5, 0.3, 0.2};
    for (DensityTerm& term : air.terms) {
        term.scattering_per_m *= 1e-6;
        term.absorption_per_m *= 1e-6;
    }
    return air;
}

/// From above, over 2 * `half` metres of x and y, for depths from 20 km of altitude to -20 km: dark beyond `from` metres of x.
/// As the second cascade; the first one is elsewhere.
ShadowMap dark_from(Backend& backend, double from, double half = 50e3) {
    constexpr std::uint32_t n = 1000;
    ShadowMap map;
    Image depth{{2 * n, 1, 1}, {}};
    for (std::uint32_t i = 0; i < 2 * n; ++i)
        depth.texels.emplace_back(((i % n + 0.5) / n * 2 - 1) * half > from ? 0 : 1, 0, 0, 0);
    map.texture = backend.make("map", rhi::Format::r32_float, depth);
    glm::dmat4& m = map.world_to_map[1];
    m = glm::dmat4(0);
    m[0][0] = m[1][1] = 0.5 / half;
    m[3][0] = m[3][1] = 0.5;
    m[2][2] = -1 / 40e3;
    m[3][2] = (ground + 20e3) / 40e3;
    m[3][3] = 1;
    map.world_to_map[0] = m;
    map.world_to_map[0][3][0] = 2e3;
    return map;
}

/// Straight down from `altitude_m`, rows along x, `half` radians to both sides.
Camera down(double altitude_m, double half) {
    Camera camera = look(ground, altitude_m, std::numbers::pi / 2, -std::numbers::pi / 2, 2 * std::atan(std::tan(half) / 8), 8);
    return camera;
}

/// Where a pixel's ray meets the ground, x in metres, and whether it lies farther than 1.5 pixels from x = `edge`.
struct Seen {
    double x;
    bool clear;
};
Seen seen(const Camera& camera, std::uint32_t column, double altitude_m, double edge) {
    const auto at = [&](double place) {
        const glm::dvec3 in_view((2 * place / size.width - 1) / camera.projection[0][0], 0, -1);
        const glm::dvec3 d = glm::normalize(glm::transpose(glm::dmat3(camera.view)) * in_view);
        const double r = ground + altitude_m, b = r * d.z;
        return d.x * (-b - std::sqrt(b * b - (r - ground) * (r + ground)));
    };
    const double x = at(column + 0.5);
    return {x, std::abs(x - edge) > 1.5 * std::abs(at(column + 1) - at(column))};
}

}  // namespace

TEST_CASE("ground shadows: with hardly any air a pixel is black or as ever, at once, from near and from space" *
          doctest::test_suite("long")) {
    Backends backends;
    const auto check = [&](Backend& backend, const ModelPtr& model) {
        CAPTURE(backend.name());
        CAPTURE(model == nullptr ? "aureole" : model->name());
        const AtmosphereParameters air = hardly_any_air();
        Rig plain(backend, setup_of(model, false, air)), shadowed(backend, setup_of(model, true, air));
        plain.record_air();
        shadowed.record_air();
        for (const double altitude : {2e3, 4e5}) {
            CAPTURE(altitude);
            const double half = altitude > 1e5 ? 0.08 : 0.6, edge = 0.2 * altitude * half;
            const Camera camera = down(altitude, half);
            shadowed.view.set_shadow_map(dark_from(backend, edge));
            plain.record_view(camera, sun_at(50));
            shadowed.record_view(camera, sun_at(50));
            const Image all = plain.show(size), left = shadowed.show(size);
            int dark = 0, lit = 0;
            for (std::uint32_t x = 0; x < size.width; ++x) {
                const Seen place = seen(camera, x, altitude, edge);
                if (!place.clear) continue;
                CAPTURE(x);
                const Rgb before(all.at(x, 0)), after(left.at(x, 0));
                CHECK(before.g == doctest::Approx(0.3 / std::numbers::pi * std::sin(50 * std::numbers::pi / 180))
                                      .scale(1e-300)
                                      .epsilon(0.03));
                if (place.x > edge)
                    CHECK(after.g < 0.005 * before.g);
                else
                    CHECK(after == before);
                ++(place.x > edge ? dark : lit);
            }
            CHECK(dark > 3);
            CHECK(lit > 3);
        }
    };
    models::HillaireSettings marched = models::HillaireSettings::low();
    marched.fast_sky = false;
    const ModelPtr models[] = {nullptr, models::single_lut({}), models::single({}), models::hillaire(marched),
                               model_by_name("bruneton", "low")};
    for (const ModelPtr& model : models) check(*backends.single, model);
    check(*backends.exact, nullptr);
    if (backends.vulkan)
        for (const ModelPtr& model : std::span(models).first(3)) check(*backends.vulkan, model);  // drivers compile slowly
}

TEST_CASE("ground shadows: the sky's light on the ground is left") {
    const auto backend = open_cpu_float();
    AtmosphereParameters air = presets::earth();
    air.planet.ground_albedo = Rgb(0.4);
    const ModelPtr all = models::aureole(QualitySettings::standard()), once = models::single_lut({});
    Rig shadowed(*backend, setup_of(all, true, air)), plain(*backend, setup_of(all, false, air)),
        single(*backend, setup_of(once, false, air)), single_dark(*backend, setup_of(once, true, air));
    shadowed.view.set_shadow_map(dark_from(*backend, -50e3));
    single_dark.view.set_shadow_map(dark_from(*backend, -50e3));
    const auto green = [&](Rig& rig) {
        rig.record_air();
        rig.record_view(down(5e3, 0.6), sun_at(40));
        return rig.show(size).at(4, 0).g;
    };
    const double lit = green(plain), lit_once = green(single);
    CHECK(lit - lit_once > 0.1 * lit);
    CHECK(green(shadowed) == doctest::Approx(lit - lit_once).scale(1e-300).epsilon(0.02));
    CHECK(green(single_dark) < 0.01 * lit_once);
}

TEST_CASE("ground shadows: the map that was set last is shown in targets that were prepared before") {
    Backends backends;
    backends.each([&](Backend& backend) {
        CAPTURE(backend.name());
        Rig rig(backend, setup_of(nullptr, true, hardly_any_air()));
        rig.record_air();
        CompositeTargets targets;
        targets.extent = size;
        targets.target = backend.make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write);
        rig.view.prepare_composite(targets);
        const auto green = [&] {
            rig.record_view(down(2e3, 0.6), sun_at(50));
            backend.run([&](rhi::CommandList& commands) { rig.view.record_composite(commands, targets); });
            return backend.read(targets.target, rhi::State::storage_write).at(5, 0).g;
        };
        const double lit = green();
        CHECK(lit > 0.01);
        rig.view.set_shadow_map(dark_from(backend, -50e3));
        CHECK(green() < 0.005 * lit);
        rig.view.set_shadow_map(dark_from(backend, 50e3));
        CHECK(green() == lit);
        rig.view.set_shadow_map(dark_from(backend, -50e3));
        rig.view.set_shadow_map({});
        CHECK(green() == lit);
    });
}

TEST_CASE("ground shadows: directions of the host's own are refused where there are shadows") {
    const auto backend = open_cpu_float();
    Rig rig(*backend, setup_of(models::single_lut({}), true, hardly_any_air()));
    CompositeTargets targets;
    targets.extent = size;
    targets.target = backend->make_target(rhi::Format::rgba32_float, size, rhi::State::storage_write);
    targets.directions =
        backend->make("directions", rhi::Format::rgba32_float, {size, std::vector<glm::dvec4>(32, {0, 0, 1, 0})});
    CHECK_THROWS_WITH_AS(rig.view.prepare_composite(targets), doctest::Contains("targets.directions"), Error);
    targets.directions = {};
    rig.view.prepare_composite(targets);
}
