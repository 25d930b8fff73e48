// The march that a host's shader makes with shadows of its own: the air's transmittance in closed form, segments that join, and
// the light that the library's own shadows leave where a shadow map says what the host's function does.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "host/compare.h"
#include "host/scenes.h"
#include "passes/trio.h"

using namespace aureole;
using namespace aureole::host;
using namespace aureole::passes;

namespace {

Question march(const glm::dvec3& direction, double begin_m, double end_m, int samples) {
    Question q;
    q.direction = direction;
    q.begin_m = begin_m;
    q.distance_m = end_m;
    q.samples = samples;
    return q;
}

/// The stripes of host_lookups.comp.glsl with sharp edges, 60 km to all sides.
ShadowMap stripes(Backend& backend, double radius_m) {
    constexpr std::uint32_t n = 240;
    Image depth{{n, 1, 1}, {}};
    for (std::uint32_t i = 0; i < n; ++i) {
        const double place = (-60 + (i + 0.5) * 120 / n) / 20;
        depth.texels.emplace_back(std::abs(place - std::floor(place) - 0.5) < 0.25 ? 0 : 1, 0, 0, 0);
    }
    ShadowMap map;
    map.texture = backend.make("stripes", rhi::Format::r32_float, depth);
    glm::dmat4& m = map.world_to_map[0];  // from above: depth 0 at 40 km, 1 at -40 km
    m = glm::dmat4(0);
    m[0][0] = m[1][1] = 1 / 120e3;
    m[3][0] = m[3][1] = 0.5;
    m[2][2] = -1 / 80e3;
    m[3][2] = (radius_m + 40e3) / 80e3;
    m[3][3] = 1;
    return map;
}

}  // namespace

TEST_CASE("march: the air's transmittance is that of the medium, straight up, and of the sky's table, also through the limb") {
    for (const char* preset : {"earth", "hazy_earth", "mars"}) {
        INFO(preset);
        Scene scene = noon();
        scene.setup.air = presets::by_name(preset);
        scene.camera = camera_at(scene.setup.air.planet, scene.altitude_m);
        Shown shown(open_cpu_double(), scene);
        constexpr double begin = 1e3, end = 2e4;
        constexpr int steps = 2000;
        Rgb depth(0);
        for (int i = 0; i < steps; ++i)
            depth +=
                sample_medium(scene.setup.air, scene.altitude_m + begin + (end - begin) * (i + 0.5) / steps).extinction_per_m *
                (end - begin) / double{steps};
        const std::vector<Question> up = {march({0, 0, 1}, begin, end, 200)};
        const Rgb got = ask(shown.rig, up)[0].march_transmittance;
        // As few samples as a host takes: each slab as it is where it is sampled.
        std::vector<Question> few = {march({0, 0, 1}, begin, end, 8)};
        few[0].jitter = 0.25;
        Rgb slabs(0);
        for (int k = 0; k < few[0].samples; ++k)
            slabs +=
                sample_medium(scene.setup.air, scene.altitude_m + begin + (end - begin) * (k + few[0].jitter) / few[0].samples)
                    .extinction_per_m *
                (end - begin) / double(few[0].samples);
        const Rgb coarse = ask(shown.rig, few)[0].march_transmittance;
        for (int c = 0; c < 3; ++c) CHECK(coarse[c] == doctest::Approx(std::exp(-slabs[c])).scale(1e-300).epsilon(1e-5));
        for (int c = 0; c < 3; ++c) CHECK(got[c] == doctest::Approx(std::exp(-depth[c])).scale(1e-300).epsilon(2e-4));
    }
    for (const double altitude : {2.0, 4e5}) {
        Scene scene = noon();
        scene.setup.quality.sky_view = {12, 600, 1};
        scene.setup.quality.sky_view_nodes = 16;
        const Planet& planet = scene.setup.air.planet;
        scene.camera = camera_at(planet, scene.altitude_m = altitude);
        Shown shown(open_cpu_double(), scene);
        std::vector<Question> rays;
        for (const double lowest : {2e3, 1e4, 3e4}) {  // up from the ground; from above, past the limb at this altitude
            const double sine =
                altitude < 1e5 ? lowest / 4e4 : (planet.bottom_radius_m + lowest) / (planet.bottom_radius_m + altitude);
            const double cosine = std::sqrt(1 - sine * sine);
            rays.push_back(march(altitude < 1e5 ? glm::dvec3{cosine, 0, sine} : glm::dvec3{sine, 0, -cosine}, 0, 1e7, 2000));
        }
        const std::vector<Answer> answers = ask(shown.rig, rays);
        host::Worst through("transmittance", 1e-2, 3e-3);
        for (std::size_t i = 0; i < answers.size(); ++i)
            through.add(i, answers[i].march_transmittance, answers[i].sky_transmittance);
        through.check();
        CHECK(answers[2].march_transmittance.b < 0.97);
        CHECK(answers[2].march_transmittance.b > 0.1);
    }
}

TEST_CASE("march: segments behind one another are one") {
    for (const Scene& scene : {noon(), scenes()[3]}) {  // on the ground; in orbit
        INFO(scene.name);
        Shown shown(open_cpu_double(), scene);
        const glm::dvec3 direction = scene.altitude_m < 1e5 ? glm::dvec3{0.8, 0, 0.6} : glm::dvec3{0.8, 0, -0.6};
        const double start = scene.altitude_m < 1e5 ? 0 : 6e5;
        const std::vector<Question> questions = {march(direction, start, start + 3e4, 12),
                                                 march(direction, start + 3e4, start + 9e4, 24),
                                                 march(direction, start, start + 9e4, 36)};
        const std::vector<Answer> a = ask(shown.rig, questions);
        for (int c = 0; c < 3; ++c) {
            const auto joined = [&](Rgb Answer::*part) {
                return doctest::Approx((a[0].*part)[c] + a[0].march_transmittance[c] * (a[1].*part)[c])
                    .scale(1e-300)
                    .epsilon(1e-6);
            };
            CHECK(a[2].march_radiance[c] == joined(&Answer::march_radiance));
            CHECK(a[2].march_loss[c] == joined(&Answer::march_loss));
            CHECK(a[2].march_transmittance[c] ==
                  doctest::Approx(a[0].march_transmittance[c] * a[1].march_transmittance[c]).scale(1e-300).epsilon(1e-6));
            CHECK(a[1].march_loss[c] > 0);
            CHECK(a[0].march_radiance[c] > 0);
        }
    }
}

TEST_CASE("march: from space the host's function is asked where the air is") {
    const Scene orbit = scenes()[3];
    Shown shown(open_cpu_double(), orbit);
    shown.rig.record_view(orbit.camera, sun_at(60));
    // Down to the middle of a dark stripe, and of a lit one; what scatters light lies within 1 km of there.
    const auto seen = [&](double x) {
        const std::vector<Question> down = {march(glm::normalize(glm::dvec3(x, 0, -orbit.altitude_m)), 0, 1e6, 200)};
        return ask(shown.rig, down)[0];
    };
    const Answer dark = seen(10e3), lit = seen(20e3);
    CHECK(lit.march_radiance.b > 0.02);
    CHECK(lit.march_loss.b < 1e-3 * lit.march_radiance.b);
    CHECK(dark.march_radiance.b < 1e-3 * lit.march_radiance.b);
    CHECK(dark.march_loss.b == doctest::Approx(lit.march_radiance.b).scale(1e-300).epsilon(0.02));
}

TEST_CASE("march: with the host's function as with a shadow map that says the same, on every backend") {
    Backends backends;
    backends.each([&](Backend& backend) {
        CAPTURE(backend.name());
        for (const bool single : {true, false}) {  // in air so thin that there is no more; with the rest, which loses as much
            CAPTURE(single);
            Setup setup;
            if (single) setup.air.planet.ground_albedo = Rgb(0);
            for (DensityTerm& term : setup.air.terms) {
                term.scattering_per_m *= single ? 1e-6 : 1.0;
                term.absorption_per_m *= single ? 1e-6 : 1.0;
            }
            setup.quality.froxel_format = rhi::Format::rgba32_float;
            setup.quality.aerial_perspective.depth = 64;
            setup.view.shadows = {.cascades = 1, .distance_m = 50e3, .size = {12, 8, 96}, .samples = 8};
            setup.composite = {
                .target_format = rhi::Format::rgba32_float, .scene_color = true, .scene_depth = true, .sun_disk = false};
            Rig rig(backend, setup);
            rig.record_air();
            const Camera camera = look(setup.air.planet.bottom_radius_m, 800, 0.5, 0.3, 0.1, 1.5);
            rig.view.set_shadow_map(stripes(backend, setup.air.planet.bottom_radius_m));
            rig.record_view(camera, sun_at(40));

            constexpr rhi::Extent extent{6, 4, 1};
            const double near = camera.projection[3][2];  // reversed, infinite: stored depth = near / view depth
            const glm::dvec3 forward = -glm::dvec3(glm::transpose(camera.view)[2]);
            Image depth{extent, {}};
            std::vector<Question> questions;
            for (std::uint32_t i = 0; i < extent.width * extent.height; ++i) {
                const bool sky = i % 4 == 3;
                Question q = pixel_question(camera, extent, i % extent.width, i / extent.width);
                double stored = 0;
                q.distance_m = 50e3;
                for (double view_depth = 4e3 + 1.7e3 * i; !sky; view_depth += 300) {  // to where the edge of a stripe is not
                    stored = static_cast<float>(near / view_depth);
                    q.distance_m = near / stored / glm::dot(q.direction, forward);
                    if (std::abs(std::fmod(std::abs(q.direction.x * q.distance_m), 10e3) - 5e3) > 1.2e3) break;
                }
                q.samples = 800;
                depth.texels.emplace_back(stored, 0, 0, 0);
                questions.push_back(q);
            }
            CompositeTargets targets;
            targets.scene_depth = backend.make("depth", rhi::Format::r32_float, depth);
            targets.scene_color =
                backend.make("black", rhi::Format::rgba32_float,
                             Image{extent, std::vector<glm::dvec4>(questions.size(), glm::dvec4(0, 0, 0, 1))});
            const Image shown = rig.show(extent, targets);
            const std::vector<Answer> answers = ask(rig, questions);
            host::Worst left("light left", 0.02, 1e-3);
            double lost = 0;
            for (std::size_t i = 0; i < answers.size(); ++i) {
                const Answer& a = answers[i];
                const bool sky = i % 4 == 3;
                if (single && sky) continue;  // beyond the shadows there is more of it
                left.add(i, single ? a.march_radiance : (sky ? a.sky : a.air_radiance) - a.march_loss, Rgb(shown.texels[i]));
                lost = std::max(lost, a.march_loss.g / (a.march_loss.g + a.march_radiance.g));
            }
            left.check();
            CHECK(lost > 0.2);
        }
    });
}
