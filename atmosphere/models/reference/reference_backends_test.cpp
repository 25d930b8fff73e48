// The path tracer on every backend: the same paths, a film that adds up, settings that are checked.
#include <aureole/models/reference.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/rejects.h"
#include "passes/scene.h"
#include "passes/trio.h"
#include "recording/allocations.h"

using namespace aureole;
using namespace aureole::passes;
using detail::rejected_field;
using models::ReferenceFilm;
using models::ReferenceSettings;

namespace {

constexpr rhi::Extent size{13, 9, 1};

Setup setup_of(const ReferenceSettings& settings, const char* preset = "earth") {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.model = models::reference(settings);
    setup.composite.target_format = rhi::Format::rgba32_float;
    setup.view.light = false;
    return setup;
}
ReferenceSettings paths(int count) {
    ReferenceSettings settings;
    settings.paths_per_frame = count;
    settings.first_order_parts = 2;
    settings.nodes = 8;
    return settings;
}
ReferenceSettings with_film(int count, rhi::Extent film = size) {
    ReferenceSettings settings = paths(count);
    settings.film_width = film.width;
    settings.film_height = film.height;
    return settings;
}

Image picture(Rig& rig, double altitude = 1500, double elevation = 20) {
    rig.record_air();
    rig.record_view(camera_at(rig.setup.air.planet, altitude), sun_at(elevation));
    return rig.show(size);
}

/// Relative differences of all numbers of two pictures, by size.
std::vector<double> differences(const Image& a, const Image& b) {
    std::vector<double> result;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double largest = std::max(std::abs(a.texels[i][c]), std::abs(b.texels[i][c]));
            result.push_back(largest > 0 ? std::abs(a.texels[i][c] - b.texels[i][c]) / largest : 0);
        }
    std::sort(result.begin(), result.end());
    return result;
}
double mean(const Image& image) {
    double sum = 0;
    for (const glm::dvec4& texel : image.texels) sum += texel.r + texel.g + texel.b;
    return sum / static_cast<double>(image.texels.size());
}

/// Equal seeds give equal paths: but for rounding, and for the few that rounding sends another way at a choice.
void check_same(const Image& a, const Image& b, const std::string& where) {
    const std::vector<double> apart = differences(a, b);
    INFO(where);
    INFO("median ", apart[apart.size() / 2], ", worst ", apart.back());
    CHECK(apart[apart.size() / 2] < 1e-4);
    CHECK(apart[apart.size() * 9 / 10] < 2e-3);
    CHECK(std::abs(mean(a) / mean(b) - 1) < 5e-3);
}

ReferenceFilm film_of(Rig& rig, rhi::Extent film) {
    std::vector<float> texels;
    for (const glm::dvec4& texel : rig.backend.read(rig.view.film_table()).texels)
        for (int c = 0; c < 4; ++c) texels.push_back(static_cast<float>(texel[c]));
    return {texels, film.width, film.height};
}

}  // namespace

TEST_CASE("reference: every backend follows the same paths, as compute and as a draw") {
    Backends backends;
    using Tracking = ReferenceSettings::Tracking;
    const struct {
        const char* preset;
        bool raster;
        Tracking tracking;
    } cases[] = {{"earth", false, Tracking::quadrature}, {"hazy_earth", true, Tracking::quadrature},
                 {"mars", false, Tracking::quadrature},  {"airless", true, Tracking::quadrature},
                 {"hazy_earth", false, Tracking::ratio}, {"us_standard_1976", true, Tracking::ratio}};
    for (const auto& [preset, raster, tracking] : cases) {
        ReferenceSettings settings = paths(4);
        settings.tracking = tracking;
        Setup setup = setup_of(settings, preset);
        setup.composite.raster = raster;
        Trio<Rig> trio(backends, setup);
        for (const double altitude : {2.0, 3e5})
            for (const double elevation : {30.0, -3.0}) {
                const auto show = [&](Rig& rig) { return picture(rig, altitude, elevation); };
                Images images{show(trio.single), show(trio.exact), {}};
                if (trio.vulkan) images.vulkan = show(*trio.vulkan);
                const std::string where = place_name(preset, altitude, elevation) + (raster ? " raster" : "") +
                                          (tracking == Tracking::ratio ? " by ratio tracking" : "");
                CHECK_MESSAGE(images.unsound() == "", where);
                if (mean(images.exact) < 1e-12) continue;
                check_same(images.single, images.exact, where + ": float and double");
                if (images.vulkan) check_same(*images.vulkan, images.single, where + ": Vulkan and float");
            }
    }
}

TEST_CASE("reference: sound in every air, from the ground to space, from noon to night") {
    const auto cpu = open_cpu_float();
    const auto vulkan = open_vulkan();
    ReferenceSettings nodes = paths(2), sampled = paths(2), tracked = paths(2);
    sampled.sampled_first_order = true;
    tracked.tracking = ReferenceSettings::Tracking::ratio;
    for (const char* preset : preset_names())
        for (const ReferenceSettings& settings : {nodes, sampled, tracked}) {
            Setup setup = setup_of(settings, preset);
            setup.view.light = !settings.sampled_first_order;
            // Kernels take seconds to compile: those that the tests above and of the light compile anyway are not compiled
            // again.
            const bool by_nodes = setup.view.light && settings.tracking == ReferenceSettings::Tracking::quadrature;
            const std::string_view name = preset;
            const bool on_vulkan = by_nodes && (name == "us_standard_1976" || name == "titan");
            for (Backend* backend : {cpu.get(), vulkan.get()}) {
                if (backend == nullptr || (backend == vulkan.get() && !on_vulkan)) continue;
                Rig rig(*backend, setup);
                rig.record_air();
                for (const double altitude : {0.0, 2.0, 1e4, 3e5})
                    for (const double elevation : {90.0, 5.0, 0.0, -4.0}) {
                        rig.record_view(camera_at(setup.air.planet, altitude), sun_at(elevation));
                        const std::string where = place_name(preset, altitude, elevation);
                        CHECK_MESSAGE(unsound(rig.show({7, 5, 1})) == "", where);
                        if (setup.view.light) CHECK_MESSAGE(unsound(rig.light(), true) == "", where);
                    }
            }
        }
}

TEST_CASE("reference: threads change nothing, frames and seeds do") {
    const auto one = open_cpu_float(1), two = open_cpu_float(2);
    Rig a(*one, setup_of(paths(4))), b(*two, setup_of(paths(4)));
    const Image first = picture(a);
    CHECK(first == picture(b));
    b.air.set_frame(1);
    CHECK(!(first == picture(b)));
    ReferenceSettings other = paths(4);
    other.seed = 1;
    Rig c(*two, setup_of(other));
    CHECK(!(first == picture(c)));
}

TEST_CASE("reference: a film adds up frames to what one frame of as many paths shows") {
    Backends backends;
    Setup whole = setup_of(paths(12)), parts = setup_of(with_film(4));
    ReferenceSettings limited = with_film(5);
    limited.max_paths = 12;
    backends.each([&](Backend& backend) {
        INFO(backend.name());
        Rig at_once(backend, whole), film(backend, parts);
        const Image expected = picture(at_once);
        Image shown = picture(film);
        CHECK(differences(shown, expected).back() > 1e-4);
        for (int frame = 1; frame < 3; ++frame) shown = picture(film);
        CHECK(differences(shown, expected).back() < 1e-5);
        const ReferenceFilm table = film_of(film, size);
        CHECK(table.paths(3, 2) == 12);
        for (int c = 0; c < 3; ++c) {
            CHECK(std::abs(table.radiance(3, 2)[c] / shown.at(3, 2)[c] - 1) < 1e-5);
            CHECK(table.standard_error(3, 2)[c] > 0);
            CHECK(table.standard_error(3, 2)[c] < table.radiance(3, 2)[c]);
        }
        // Another place: from the start. Another exposure is no other place.
        shown = picture(film, 3000);
        CHECK(film_of(film, size).paths(0, 0) == 4);
        film.view.set_exposure(2);
        CHECK(mean(picture(film, 3000)) > 1.5 * mean(shown));
        CHECK(film_of(film, size).paths(0, 0) == 8);
        film.view.invalidate();
        (void)picture(film, 3000);
        CHECK(film_of(film, size).paths(0, 0) == 4);
    });
    // As many as were asked for, and no more: what is counted on no device.
    Rig at_once(*backends.single, whole), slow(*backends.single, setup_of(limited));
    const Image expected = picture(at_once);
    Image shown = expected;
    for (int frame = 0; frame < 4; ++frame) shown = picture(slow);
    CHECK(film_of(slow, size).paths(0, 0) == 12);
    CHECK(!slow.view.reports()[0].recorded);
    CHECK(differences(shown, expected).back() < 1e-5);
}

TEST_CASE("reference: a frame's paths in several dispatches are those of one") {
    Backends backends;
    constexpr rhi::Extent few{5, 3, 1};
    const auto show = [&](Backend& backend, const ReferenceSettings& settings, int frames) {
        Rig rig(backend, setup_of(settings));
        for (int frame = 0; frame < frames; ++frame) {
            rig.record_air();
            rig.record_view(camera_at(rig.setup.air.planet, 1500), sun_at(20));
        }
        if (settings.film_width > 0) CHECK(film_of(rig, few).paths(4, 2) == 70);
        if (frames == 1 && settings.film_width > 0) CHECK(rig.view.reports()[0].invocations == 3 * few.width * few.height);
        return rig.show(few);
    };
    for (Backend* backend : {backends.single.get(), backends.exact.get()}) {
        const Image undivided = show(*backend, paths(70), 1);
        CHECK(show(*backend, with_film(70, few), 1) == undivided);
        CHECK(show(*backend, with_film(35, few), 2) == undivided);
    }
    // Far more than llvmpipe lets one invocation do.
    if (!backends.vulkan) return;
    ReferenceSettings many = with_film(300, few);
    Rig single(*backends.single, setup_of(many)), vulkan(*backends.vulkan, setup_of(many));
    check_same(picture(vulkan), picture(single), "300 paths a frame");
    CHECK(film_of(vulkan, few).paths(4, 2) == 300);
}

TEST_CASE("reference: what the qualities ask of an invocation is not too much for llvmpipe") {
    const auto cpu = open_cpu_float(), vulkan = open_vulkan();
    if (!vulkan) return;
    const Setup setup = setup_of(ReferenceSettings::by_name("high"), "hazy_earth");
    Rig single(*cpu, setup), other(*vulkan, setup);
    for (const auto& [altitude, elevation] : {std::pair(2.0, -3.0), {3e5, 5.0}})
        check_same(picture(other, altitude, elevation), picture(single, altitude, elevation),
                   place_name("hazy_earth", altitude, elevation));
}

TEST_CASE("reference: the error shown is the film's, and that of pictures that differ by their frames alone") {
    const auto cpu = open_cpu_double();
    ReferenceSettings settings = with_film(16);
    settings.show = ReferenceSettings::Show::standard_error;
    Rig rig(*cpu, setup_of(settings));
    const Image shown = picture(rig);
    const ReferenceFilm film = film_of(rig, size);
    for (std::uint32_t x = 0; x < size.width; ++x)
        CHECK(film.standard_error(x, 3).g == doctest::Approx(shown.at(x, 3).g).scale(1e-300).epsilon(1e-5));

    Rig noisy(*cpu, setup_of(paths(16)));
    constexpr int frames = 40;
    glm::dvec4 sum(0), squares(0);
    for (int frame = 0; frame < frames; ++frame) {
        noisy.air.set_frame(static_cast<std::uint64_t>(frame));
        for (const glm::dvec4& texel : {picture(noisy).at(6, 1)}) sum += texel, squares += texel * texel;
    }
    ReferenceSettings direct = paths(16 * frames);
    direct.show = settings.show;
    Rig error(*cpu, setup_of(direct));
    const double spread = std::sqrt((squares.g - sum.g * sum.g / frames) / (frames - 1.0) / frames);
    CHECK(picture(error).at(6, 1).g == doctest::Approx(spread).scale(1e-300).epsilon(0.35));
}

TEST_CASE("reference: a film of another size is interpolated") {
    const auto cpu = open_cpu_float();
    Rig fine(*cpu, setup_of(with_film(64))), coarse(*cpu, setup_of(with_film(64, {26, 18, 1})));
    const std::vector<double> apart = differences(picture(fine), picture(coarse));
    CHECK(apart[apart.size() / 2] < 0.03);
}

TEST_CASE("reference: air before geometry") {
    const auto cpu = open_cpu_double();
    Setup setup = setup_of(paths(64));
    setup.composite.scene_color = setup.composite.scene_depth = true;
    Rig rig(*cpu, setup);
    const DepthConvention convention = perspective_conventions(1.5)[0];
    Camera camera = camera_at(setup.air.planet, 1500);
    camera.projection = convention.projection;
    rig.record_air();
    rig.record_view(camera, sun_at(20));
    const auto at = [&](double distance) {
        const SceneTextures scene = upload(
            *cpu, size, [=](auto, auto) { return distance; }, convention);
        return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
    };
    const Image near = at(1), far = at(3e4), farther = at(9e4), sky = at(std::numeric_limits<double>::infinity());
    CHECK(unsound(near) == "");
    CHECK(near.at(4, 4).g == doctest::Approx(0.2 * (1 + 4 % 2)).scale(1e-300).epsilon(0.01));  // scene.cpp's colour, as it is
    // Upwards, beyond all air, geometry has the sky before it, and shines through as stars do (a two-hundredth as bright).
    const Image beyond = at(5e6);
    const double stars = sky.at(4, 0).g, hill = beyond.at(4, 0).g;
    CHECK(hill > stars);
    CHECK(mean(far) != mean(farther));
    CHECK(unsound(far) == "");
}

TEST_CASE("reference: recording allocates nothing") {
    const auto cpu = cpu::create_cpu_device({});
    ReferenceSettings settings = with_film(1);
    Atmosphere air(cpu->device(), presets::earth(), models::reference(settings));
    View view(air, {.light = false}, {});
    const Sun sun = sun_at(20);
    for (int frame = 0; frame < 3; ++frame) {
        view.update(camera_at(air.parameters().planet, 10.0 * frame), {&sun, 1});
        rhi::CommandList& list = cpu->queue().begin();
        recording::begin_counting_allocations();
        air.record(list);
        view.record(list);
        const int allocations = recording::end_counting_allocations();
        cpu->queue().submit();
        cpu->queue().wait();
        if (frame > 0) CHECK(allocations == 0);  // the device's own list grows to its size in the first
        CHECK(view.reports()[0].recorded);
    }
}

TEST_CASE("reference: settings are checked, by field") {
    const auto rejected = [](auto change) {
        ReferenceSettings settings;
        change(settings);
        return rejected_field([&] { (void)models::reference(settings); });
    };
    using S = ReferenceSettings;
    CHECK(rejected([](S& s) { s.paths_per_frame = -1; }) == "reference.paths_per_frame");
    CHECK(rejected([](S& s) { s.paths_per_frame = 65537; }) == "reference.paths_per_frame");
    CHECK(rejected([](S& s) { s.max_paths = 0; }) == "reference.max_paths");
    CHECK(rejected([](S& s) { s.film_width = 4; }) == "reference.film_height");
    CHECK(rejected([](S& s) { s.film_height = 4; }) == "reference.film_width");
    CHECK(rejected([](S& s) { s.max_order = 4097; }) == "reference.max_order");
    CHECK(rejected([](S& s) { s.first_order_parts = 3; }) == "reference.first_order_parts");
    CHECK(rejected([](S& s) { s.nodes = 3; }) == "reference.nodes");
    CHECK(rejected([](S& s) { s.nodes = 17; }) == "reference.nodes");
    CHECK(rejected([](S& s) { s.roulette_order = 0; }) == "reference.roulette_order");
    CHECK(rejected([](S& s) { s.seed = -1; }) == "reference.seed");
    CHECK(rejected([](S& s) { s.light_paths = 4097; }) == "reference.light_paths");
    CHECK(rejected([](S& s) { s.show = static_cast<S::Show>(2); }) == "reference.show");
    CHECK(rejected([](S& s) { s.tracking = static_cast<S::Tracking>(2); }) == "reference.tracking");
    CHECK(rejected_field([] { (void)S::by_name("best"); }) == "quality");
    CHECK(rejected_field([] { ReferenceFilm({}, 0, 0); }) == "texels");
    const std::vector<float> texels(12);
    CHECK(rejected_field([&] { (void)ReferenceFilm(texels, 1, 1).radiance(1, 0); }) == "x");
    CHECK(rejected_field([&] { (void)ReferenceFilm(texels, 1, 1).paths(0, 1); }) == "y");
}
