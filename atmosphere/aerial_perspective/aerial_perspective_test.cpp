// The aerial-perspective pass on every backend, from the ground to space, from noon to night.
#include <doctest/doctest.h>

#include "passes/trio.h"

using namespace aureole;
using namespace aureole::passes;

namespace {

// Light a billionth of the brightest in the froxels is not seen, nor 1e-20 of the sun's; a millionth of optical depth takes
// nothing away.
constexpr Measure radiance{Measure::Kind::relative, 1e-20, 1e-9};
constexpr Measure depth{Measure::Kind::relative, 1e-6};

struct Parts {
    Precision radiance, depth;

    void compare(const Images& tables, std::uint32_t rows, const std::string& where) {
        depth.compare(tables, 0, rows, ::depth, where);
        for (std::uint32_t layer = rows; layer < tables.single.extent.height; layer += rows)
            radiance.compare(tables, layer, rows, ::radiance, where);
    }
    void check(const std::string& how) const {
        radiance.check("aerial perspective", "radiance, " + how, 1e-4, 1e-3);
        depth.check("aerial perspective", "optical depth, " + how, 1e-4, 1e-3);
    }
};

Setup setup_of(const char* preset) {
    Setup setup;
    setup.air = presets::by_name(preset);
    setup.view.light = false;
    return setup;
}

}  // namespace

TEST_CASE("aerial perspective: every backend makes the same froxels, at all altitudes and hours") {
    Backends backends;
    Parts alone, chained;
    for (const char* preset : preset_names()) {
        const Setup setup = setup_of(preset);
        for (Parts* parts : {&chained, &alone}) {
            Trio<Rig> trio(backends, setup);
            trio.record_air();
            if (parts == &alone) trio.share_air();
            sweep(trio, preset, [&](const std::string& where) {
                const Images tables = trio.read(&Rig::froxels);
                CHECK_MESSAGE(tables.unsound() == "", where);
                parts->compare(tables, setup.quality.aerial_perspective.height, where);
            });
        }
    }
    alone.check("alone");
    chained.check("own tables");
}

namespace {

/// Day, twilight; in the air and in space.
template <class Visit>
void visit_some(Trio<Rig>& trio, const std::string& name, const std::function<Camera(double)>& camera, const Visit& visit) {
    for (const double altitude : {0.0, 5e3, 4e5}) {
        for (const double elevation : {60.0, 4.0, -3.0}) {
            trio.each([&](Rig& rig) { rig.record_view(camera(altitude), sun_at(elevation)); });
            visit(place_name(name, altitude, elevation));
        }
    }
}

const Planet earth = presets::earth().planet;

Camera parallel_camera(double altitude) {
    Camera camera = camera_at(earth, altitude);
    camera.projection = glm::dmat4(1);
    camera.projection[0][0] = camera.projection[1][1] = 1e-3;
    camera.projection[2][2] = -1e-5;
    return camera;
}

}  // namespace

TEST_CASE("aerial perspective: froxels of any shape, depth and projection") {
    Backends backends;
    Parts parts;
    struct Variant {
        const char* name;
        rhi::Extent shape;
        int slabs;
        double distance_m;
        Projection kind;
        bool parallel;
    };
    for (const Variant& v : {Variant{"deep", {5, 3, 17}, 1, 2e6, Projection::matrix, false},
                             {"thin slabs", {8, 8, 8}, 5, 5e3, Projection::matrix, false},
                             {"least", {2, 2, 2}, 8, 1, Projection::matrix, false},
                             {"orthographic", {7, 9, 4}, 1, 96e3, Projection::matrix, true},
                             {"panorama", {12, 7, 5}, 1, 96e3, Projection::panorama, false},
                             {"fisheye", {6, 6, 5}, 1, 96e3, Projection::fisheye, false}}) {
        Setup setup = setup_of("earth");
        setup.quality.aerial_perspective = v.shape;
        setup.quality.aerial_perspective_nodes = v.slabs;
        setup.quality.froxel_format = rhi::Format::rgba32_float;
        setup.view.aerial_perspective_distance_m = v.distance_m;
        setup.view.projection = v.kind;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        trio.share_air();
        const auto camera = [&](double altitude) {
            Camera made = v.parallel ? parallel_camera(altitude) : camera_at(earth, altitude);
            made.kind = v.kind;
            return made;
        };
        visit_some(trio, v.name, camera, [&](const std::string& where) {
            const Images tables = trio.read(&Rig::froxels);
            CHECK_MESSAGE(tables.unsound() == "", where);
            parts.compare(tables, v.shape.height, where);
        });
    }
    parts.check("other shapes, alone");
}

TEST_CASE("aerial perspective: half floats differ by a step at most") {
    Backends backends;
    Precision worst;
    for (const char* preset : preset_names()) {
        Setup setup = setup_of(preset);
        setup.quality.froxel_format = rhi::Format::rgba16_float;
        Trio<Rig> trio(backends, setup);
        trio.record_air();
        trio.share_air();
        sweep(trio, preset, [&](const std::string& where) {
            const Images tables = trio.read(&Rig::froxels);
            CHECK_MESSAGE(tables.unsound() == "", where);
            worst.compare(tables, {Measure::Kind::half_steps}, where);
        });
    }
    worst.check("aerial perspective", "in half, steps", 1, 0.6);
}

TEST_CASE("aerial perspective: nothing at the camera, more with every slice, and every sun has its own layers") {
    const auto cpu = open_cpu_float();
    Setup setup = setup_of("earth");
    Rig alone(*cpu, setup);
    setup.view.max_suns = 2;
    Rig together(*cpu, setup);
    const Camera camera = camera_at(earth, 2);
    const Sun suns[] = {sun_at(50), sun_at(5)};
    alone.record_air();
    together.record_air();
    together.record_view(camera, suns);
    const Image all = together.froxels();
    const std::uint32_t rows = setup.quality.aerial_perspective.height;
    REQUIRE(all.extent.height == rows * (1 + 2 * 2));
    for (std::uint32_t y = 0; y < all.extent.height; ++y)
        for (std::uint32_t x = 0; x < all.extent.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                CHECK(all.at(x, y, 0)[channel] == 0);
                for (std::uint32_t z = 1; z < all.extent.depth; ++z)
                    CHECK(all.at(x, y, z)[channel] >= all.at(x, y, z - 1)[channel]);
            }
    for (std::uint32_t sun = 0; sun < 2; ++sun) {
        alone.record_view(camera, suns[sun]);
        const Image one = alone.froxels();
        Worst worst;
        for (std::uint32_t z = 0; z < one.extent.depth; ++z)
            for (std::uint32_t y = rows; y < one.extent.height; ++y)
                for (std::uint32_t x = 0; x < one.extent.width; ++x) {
                    const double a = all.at(x, y + sun * 2 * rows, z).y, b = one.at(x, y, z).y;
                    worst.add(difference(a, b, {}), a, b, "sun " + std::to_string(sun));
                }
        INFO(worst.text());
        CHECK(worst.error() < 1e-6);
    }
}
