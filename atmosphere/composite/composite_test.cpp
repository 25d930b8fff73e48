// The composite on every backend, as compute and as a draw, over a host's colour and depth in every convention.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "passes/scene.h"
#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr rhi::Extent size{37, 23, 1};
constexpr double aspect = 37.0 / 23.0;
constexpr Measure radiance{Measure::Kind::relative, 0, 1e-6};

Setup setup_of(bool raster, bool scene = true) {
    Setup setup;
    setup.composite = {
        .target_format = rhi::Format::rgba32_float, .raster = raster, .scene_color = scene, .scene_depth = scene};
    setup.view.light = false;
    return setup;
}

Camera camera_of(const DepthConvention& convention, double altitude = 1500, RowOrder order = RowOrder::top_first) {
    Camera camera = camera_at(presets::earth().planet, altitude);
    camera.projection = convention.projection;
    camera.depth_range = convention.range;
    camera.row_order = order;
    return camera;
}

/// Records the view of one rig and shows it over the landscape.
Image picture(Rig& rig, const DepthConvention& convention, RowOrder order = RowOrder::top_first,
              rhi::Format depth_format = rhi::Format::r32_float) {
    rig.record_view(camera_of(convention, 1500, order), sun_at(20));
    const SceneTextures scene = upload(rig.backend, size, patches, convention, order, depth_format);
    return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
}

Image upside_down(const Image& image) {
    Image flipped{image.extent, {}};
    for (std::uint32_t y = image.extent.height; y-- > 0;)
        for (std::uint32_t x = 0; x < image.extent.width; ++x) flipped.texels.push_back(image.at(x, y));
    return flipped;
}

void check_close(const Image& a, const Image& b, double bound, const std::string& where) {
    Worst worst;
    worst.compare(a, b, radiance, where);
    INFO(worst.text());
    CHECK(worst.error() <= bound);
}

}  // namespace

TEST_CASE("composite: every backend shows the same picture, as compute and as a draw, in every depth convention") {
    Backends backends;
    Precision alone, chained;
    for (const bool raster : {false, true}) {
        for (const bool shared : {true, false}) {
            Trio<Rig> trio(backends, setup_of(raster));
            trio.record_air();
            if (shared) trio.share_air();
            for (const auto& conventions : {perspective_conventions(aspect), orthographic_conventions(aspect)}) {
                for (const DepthConvention& convention : conventions) {
                    for (const double elevation : {20.0, -4.0}) {
                        const std::string where = convention.name + (raster ? ", raster" : ", compute");
                        trio.each([&](Rig& rig) { rig.record_view(camera_of(convention), sun_at(elevation)); });
                        if (shared) share_view(trio);
                        const auto show = [&](Rig& rig) {
                            const SceneTextures scene = upload(rig.backend, size, patches, convention);
                            return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
                        };
                        Images images{show(trio.single), show(trio.exact), {}};
                        if (trio.vulkan) images.vulkan = show(*trio.vulkan);
                        CHECK_MESSAGE(images.unsound() == "", where);
                        (shared ? alone : chained).compare(images, radiance, where);
                    }
                }
            }
        }
    }
    alone.check("composite", "radiance, alone", 1e-4, 1e-3);
    chained.check("composite", "radiance, own tables", 1e-4, 1e-3);
}

namespace {

/// Pictures of the landscape, or of what is behind it, at all altitudes and hours: each backend from its own tables of the
/// view, then from the same ones.
void sweep_pictures(Backends& backends, const char* preset, rhi::Format target, const Measure& measure, Precision& alone,
                    Precision& chained) {
    constexpr rhi::Extent small{13, 9, 1};
    const DepthConvention convention = perspective_conventions(13.0 / 9.0).front();
    Setup setup = setup_of(false);
    setup.air = presets::by_name(preset);
    setup.composite.target_format = target;
    Trio<Rig> trio(backends, setup);
    trio.record_air();
    std::vector<std::pair<Rig*, SceneTextures>> scenes;
    trio.each([&](Rig& rig) { scenes.emplace_back(&rig, upload(rig.backend, small, patches, convention)); });
    const auto show = [&](Rig& rig) {
        const auto scene = std::find_if(scenes.begin(), scenes.end(), [&](const auto& of) { return of.first == &rig; })->second;
        return rig.show(small, {.scene_color = scene.color, .scene_depth = scene.depth});
    };
    const auto show_all = [&] {
        Images images{show(trio.single), show(trio.exact), {}};
        if (trio.vulkan) images.vulkan = show(*trio.vulkan);
        return images;
    };
    const Planet& planet = setup.air.planet;
    for (const double altitude : altitudes_m(planet))
        for (const double elevation : elevations_deg()) {
            const std::string where = place_name(preset, altitude, elevation);
            Camera camera = camera_at(planet, altitude);
            camera.projection = convention.projection;
            trio.each([&](Rig& rig) { rig.record_view(camera, sun_at(elevation)); });
            const Images own = show_all();
            CHECK_MESSAGE(own.unsound() == "", where);
            chained.compare(own, measure, where);
            share_view(trio);
            alone.compare(show_all(), measure, where);
        }
}

}  // namespace

TEST_CASE("composite: every backend shows the same picture of every air, at all altitudes and hours") {
    Backends backends;
    Precision alone, chained;
    for (const char* preset : preset_names())
        sweep_pictures(backends, preset, rhi::Format::rgba32_float, radiance, alone, chained);
    alone.check("composite", "all places and hours, alone", 1e-4, 1e-3);
    chained.check("composite", "all places and hours, own tables", 1e-4, 1e-3);
}

TEST_CASE("composite: targets in half floats differ by a step at most, at all altitudes and hours") {
    Backends backends;
    Precision alone, chained;
    for (const char* preset : preset_names())
        sweep_pictures(backends, preset, rhi::Format::rgba16_float, {Measure::Kind::half_steps}, alone, chained);
    alone.check("composite", "in half, alone, steps", 1, 0.6);
    chained.check("composite", "in half, own tables, steps", 1, 1.6);
}

TEST_CASE("composite: all depth conventions show one picture") {
    const auto cpu = open_cpu_float();
    for (const bool raster : {false, true}) {
        Rig rig(*cpu, setup_of(raster));
        rig.record_air();
        for (const auto& conventions : {perspective_conventions(aspect), orthographic_conventions(aspect)}) {
            const Image reference = picture(rig, conventions.front());
            for (const DepthConvention& convention : conventions) {
                // Forward depth in float is coarse at 80 km: that is the host's choice.
                check_close(picture(rig, convention), reference, 3e-3, convention.name);
                check_close(upside_down(picture(rig, convention, RowOrder::bottom_first)), picture(rig, convention), 1e-5,
                            convention.name + ", bottom first");
            }
        }
    }
}

// As in Vulkan: the same pixels come from an unflipped projection under a viewport of negative height, whose row 0 is clip y
// +1, and from a flipped one under a viewport of positive height, whose row 0 is clip y -1. Only signs differ: not even a
// rounding.
TEST_CASE("composite: a flipped projection, bottom first, shows what an unflipped one shows top first") {
    const auto cpu = open_cpu_float();
    Rig rig(*cpu, setup_of(false));
    rig.record_air();
    for (const auto& conventions : {perspective_conventions(aspect), orthographic_conventions(aspect)}) {
        for (const DepthConvention& convention : conventions) {
            Camera camera = camera_of(convention);
            const SceneTextures scene = upload(rig.backend, size, patches, convention);
            const auto shown = [&] {
                rig.record_view(camera, sun_at(20));
                return rig.show(size, {.scene_color = scene.color, .scene_depth = scene.depth});
            };
            const Image unflipped = shown();
            for (int column = 0; column < 4; ++column) camera.projection[column][1] *= -1;
            // Upside down, and not alike then; parallel rays have one direction.
            if (camera.projection[2][3] != 0) CHECK(shown() != unflipped);
            camera.row_order = RowOrder::bottom_first;
            check_close(shown(), unflipped, 0, convention.name);
        }
    }
}

TEST_CASE("composite: a draw shows what compute shows, and a d32_float depth buffer what r32_float does") {
    const auto show_all = [](Backend& backend) {
        const DepthConvention convention = perspective_conventions(aspect).front();
        Rig compute(backend, setup_of(false)), raster(backend, setup_of(true));
        compute.record_air();
        raster.record_air();
        const Image reference = picture(compute, convention);
        check_close(picture(raster, convention), reference, 1e-5, "raster");
        check_close(picture(compute, convention, RowOrder::top_first, rhi::Format::d32_float), reference, 0, "d32_float");
    };
    show_all(*open_cpu_float());
    if (const auto vulkan = open_vulkan()) show_all(*vulkan);
}

TEST_CASE("composite: every backend shows the same sky in every projection, from the ground to space") {
    Backends backends;
    Precision worst;
    for (const Projection kind : {Projection::matrix, Projection::panorama, Projection::fisheye}) {
        Setup setup = setup_of(kind == Projection::fisheye, false);
        setup.view.projection = kind;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        for (const double altitude : {0.0, 0.01, 2.0, 1e4, 99999.0, 100001.0, 4e5, 1e6}) {
            for (const double elevation : {35.0, 0.0, -5.0}) {
                const std::string where = place_name("kind " + std::to_string(static_cast<int>(kind)), altitude, elevation);
                Camera camera = camera_at(setup.air.planet, altitude);
                camera.kind = kind;
                trio.each([&](Rig& rig) { rig.record_view(camera, sun_at(elevation)); });
                Images images{trio.single.show(size), trio.exact.show(size), {}};
                if (trio.vulkan) images.vulkan = trio.vulkan->show(size);
                CHECK_MESSAGE(images.unsound() == "", where);
                worst.compare(images, radiance, where);
            }
        }
    }
    worst.check("composite", "sky, own tables", 1e-4, 1e-3);
}

TEST_CASE("composite: given directions show what the camera's own rays do") {
    Backends backends;
    Setup setup = setup_of(false, false);
    Trio<Rig> trio(backends, setup);
    trio.record_air();
    const DepthConvention convention = perspective_conventions(aspect).front();
    const Camera camera = camera_of(convention, 3e3);
    Image directions{size, {}};
    const glm::dmat3 to_world = glm::transpose(glm::dmat3(camera.view));
    for (std::uint32_t y = 0; y < size.height; ++y)
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const glm::dvec3 ray((2 * (x + 0.5) / size.width - 1) / camera.projection[0][0],
                                 (1 - 2 * (y + 0.5) / size.height) / camera.projection[1][1], -1);
            directions.texels.emplace_back(to_world * ray * 0.3, 1);  // of any length
        }
    Precision worst;
    Images given;
    trio.each([&](Rig& rig) {
        rig.record_view(camera, sun_at(20));
        const Image own = rig.show(size);
        const Image shown =
            rig.show(size, {.directions = rig.backend.make("directions", rhi::Format::rgba32_float, directions)});
        check_close(shown, own, 1e-4, rig.backend.name());
        if (&rig == &trio.single)
            given.single = shown;
        else if (&rig == &trio.exact)
            given.exact = shown;
        else
            given.vulkan = shown;
    });
    worst.compare(given, radiance, "given directions");
    worst.check("composite", "given directions, own tables", 1e-4, 1e-3);
}
