// A sun of 1.3e5 lux and a night sky of 1e-6 cd/m^2 in one frame of half floats. What is stored in these is 6e-8 to 64512,
// twelve decades; this frame has eleven of them, and the host's pre-exposure (CompositeSettings::exposure) puts them there.
#include "passes/rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace aureole;
using namespace aureole::passes;

namespace {

constexpr double sun_lux = 1.3e5, night_sky = 1e-6;
constexpr rhi::Extent extent{64, 33, 1};  // a row on the horizon of the infinite
/// The brightest light of the air then just fits: it is less than the sun's irradiance in any steradian.
constexpr double most = 64512, pre_exposure = most / sun_lux;
constexpr double half_step = 1.0 / (1 << 24);  // of the smallest half floats

Setup whole_sphere(rhi::Format target, rhi::Format tables) {
    Setup setup;
    setup.quality.table_format = tables;
    setup.view.projection = Projection::panorama;
    setup.view.aerial_perspective = false;
    setup.view.light = false;
    setup.composite.target_format = target;
    setup.composite.scene_color = true;
    setup.composite.exposure = pre_exposure;
    return setup;
}

struct Place {
    double altitude_m, sun_elevation_deg;
};
// Over the terminator, with the umbra below and the day beyond; from far away; by day; by night.
constexpr Place places[] = {{4e5, -5}, {3.6e7, 10}, {2, 40}, {2, -18}};

/// Pixels of the frame, still exposed. The sun's disk is wide enough for a pixel to hit, and brighter than half floats go.
Image frame(Backend& backend, const Setup& setup, const Place& place) {
    Rig rig(backend, setup);
    rig.record_air();
    Sun sun = sun_at(place.sun_elevation_deg);
    sun.irradiance = Rgb(sun_lux);
    sun.angular_radius_rad = 0.1;
    Camera camera = camera_at(setup.air.planet, place.altitude_m);
    camera.kind = Projection::panorama;
    rig.record_view(camera, sun);
    Image stars{extent, {}};
    stars.texels.assign(std::size_t{extent.width} * extent.height, glm::dvec4(night_sky, night_sky, night_sky, 1));
    CompositeTargets targets;
    targets.scene_color = backend.make("night sky", rhi::Format::rgba32_float, stars);
    return rig.show(extent, targets);
}

/// The most by which half floats are off, each beyond what the other bound allows.
struct Off {
    double relative = 0;  ///< Beyond `step`.
    double steps = 0;     ///< Of the smallest half floats, where they are as far apart as these: below 2^-14.
};

Off compare(const Image& seen, const Image& exact, double step) {
    Off off;
    for (std::size_t i = 0; i < exact.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double is = seen.texels[i][c], wanted = std::min(exact.texels[i][c], most);
            CHECK(std::isfinite(is));
            CHECK(is >= 0);
            const double difference = std::abs(is - wanted);
            if (wanted < 6.1e-5) off.steps = std::max(off.steps, difference / half_step);
            if (wanted > 0) off.relative = std::max(off.relative, (difference - step) / wanted);
        }
    return off;
}

}  // namespace

TEST_CASE("stability: the sun's light and a night sky fit into one frame of half floats") {
    constexpr rhi::Format half = rhi::Format::rgba16_float, full = rhi::Format::rgba32_float;
    const auto exact_backend = open_cpu_double();
    for (const auto& backend : {open_cpu_float(), open_vulkan()}) {
        if (!backend) continue;
        INFO(backend->name());
        for (const Place& place : places) {
            INFO("altitude ", place.altitude_m, " m, sun at ", place.sun_elevation_deg, " degrees");
            const Image exact = frame(*exact_backend, whole_sphere(full, full), place);
            // Some drivers cut digits off instead of rounding: a step, not half of one.
            const Off target = compare(frame(*backend, whole_sphere(half, full), place), exact, half_step);
            CHECK(target.steps <= 1.01);
            CHECK(target.relative <= 1.01 / 1024);
            // Tables hold light as a share of the sun's: by day a step of theirs hides a night sky.
            const double table_step = pre_exposure * sun_lux * half_step;
            const Off both = compare(frame(*backend, whole_sphere(half, half), place), exact, table_step);
            CHECK(both.steps * half_step <= table_step / 2);
            CHECK(both.relative <= 2.0 / 1024);
        }
    }
}
