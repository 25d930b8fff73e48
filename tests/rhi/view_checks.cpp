// The passes of a view, against the CPU backend, each from the CPU's tables of the air.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rhi/checks.h"
#include "rhi/pass_rig.h"

namespace aureole::conformance {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Light a thousandth as bright as the brightest, and a thousandth of an optical depth, are measured against that.
constexpr Measure radiance{Measure::Kind::relative, 1e-20, 1e-3};
constexpr Measure optical_depth{Measure::Kind::relative, 1e-3};

PassSetup setup_of(bool aerial_perspective, bool light) {
    PassSetup setup;
    setup.view.emplace();
    setup.view->aerial_perspective = aerial_perspective;
    setup.view->light = light;
    return setup;
}

/// Records the view everywhere, and calls `visit` with its table and the place's name.
template <class Visit>
void compare_everywhere(const Target& target, const PassSetup& setup, rhi::Texture (View::*table)() const noexcept,
                        bool signed_too, const Visit& visit) {
    PassPair pair(target, setup);
    pair.record_air();
    pair.share_air();
    for (const PlaceAndHour& place : places_and_hours) {
        const Context context(place.name());
        pair.record_view(passes::camera_at(setup.air.planet, place.altitude_m), passes::sun_at(place.elevation_deg));
        const auto tables = pair.read([&](const PassRig& rig) { return (rig.view.get()->*table)(); });
        const std::string problem = passes::unsound(tables.checked, signed_too);
        expect(problem.empty(), "the table holds " + problem);
        visit(tables, place.name());
    }
}

}  // namespace

void check_sky_view(const Target& target) {
    const PassSetup setup = setup_of(false, false);
    const std::uint32_t rows = setup.quality.sky_view.height;
    Difference light("radiance"), depth("optical depth");
    compare_everywhere(
        target, setup, &View::sky_view_table, false, [&](const PassPair::Tables& tables, const std::string& where) {
            const std::uint32_t last = tables.checked.extent.height - rows;  // layers of light, then one of depths
            for (std::uint32_t layer = 0; layer < last; layer += rows) light.compare(tables, layer, rows, radiance, where);
            depth.compare(tables, last, rows, optical_depth, where);
        });
    light.tell(target.pass_tolerance);
    depth.tell(target.pass_tolerance);
}

void check_aerial_perspective(const Target& target) {
    const PassSetup setup = setup_of(true, false);
    const std::uint32_t rows = setup.quality.aerial_perspective.height;
    Difference light("radiance"), depth("optical depth");
    compare_everywhere(target, setup, &View::aerial_perspective_table, false,
                       [&](const PassPair::Tables& tables, const std::string& where) {
                           depth.compare(tables, 0, rows, optical_depth, where);
                           for (std::uint32_t layer = rows; layer < tables.checked.extent.height; layer += rows)
                               light.compare(tables, layer, rows, radiance, where);
                       });
    light.tell(target.pass_tolerance);
    depth.tell(target.pass_tolerance);
}

void check_light(const Target& target) {
    // Nine harmonics of the sky, measured by the first, which bounds the others; then the sun.
    constexpr std::uint32_t sun_column = 9;
    Difference sky("harmonics of the sky"), sun("sun at the camera");
    compare_everywhere(
        target, setup_of(false, true), &View::light_table, true, [&](const PassPair::Tables& tables, const std::string& where) {
            const Image &a = tables.checked, &b = tables.reference;
            for (int channel = 0; channel < 3; ++channel)
                for (std::uint32_t i = 0; i <= sun_column; ++i) {
                    const double scale =
                        i == sun_column ? std::abs(b.at(i, 0)[channel]) + 1e-3 : std::abs(b.at(0, 0)[channel]) + 1e-12;
                    const double p = a.at(i, 0)[channel], q = b.at(i, 0)[channel];
                    (i == sun_column ? sun : sky).add(p, q, std::abs(p - q) / scale, where);
                }
        });
    sky.tell(target.pass_tolerance);
    sun.tell(target.pass_tolerance);
}

namespace {

/// Patches of geometry at several distances, and holes through which the sky is seen: not symmetric in any way.
double distance_at(std::uint32_t x, std::uint32_t y) {
    constexpr double distances_m[] = {20, 400, 3e3, infinity, 15e3, 80e3, 7e3};
    return distances_m[(x / 5 + 3 * (y / 4)) % 7];
}

constexpr double near_m = 0.1;

/// The same on both devices: colours, and depths as the projection of look() has them, near / distance.
void give_scene(PassRig& rig, rhi::Format depth_format, CompositeTargets& targets) {
    Image color{targets.extent, {}}, depth{targets.extent, {}};
    for (std::uint32_t y = 0; y < targets.extent.height; ++y)
        for (std::uint32_t x = 0; x < targets.extent.width; ++x) {
            const double distance = distance_at(x, y), shine = std::isinf(distance) ? 1e-3 : 0.2;
            depth.texels.emplace_back(near_m / distance, 0, 0, 1);
            color.texels.emplace_back(shine * (1 + x % 3), shine * (1 + y % 2), 0.7 * shine, 1);
        }
    const bool is_depth = depth_format == rhi::Format::d32_float;
    targets.scene_color = rig.make("scene color", rhi::Format::rgba32_float, color, rhi::State::sampled);
    targets.scene_depth = rig.make("scene depth", depth_format, depth, is_depth ? rhi::State::depth_read : rhi::State::sampled);
}

void check_picture(const Target& target, bool drawn) {
    const rhi::Format depth_format = drawn && target.device.format_support(rhi::Format::d32_float, rhi::Dimension::d2).sampled
                                         ? rhi::Format::d32_float
                                         : rhi::Format::r32_float;
    PassSetup setup = setup_of(true, false);
    const rhi::FormatSupport floats = target.device.format_support(rhi::Format::rgba32_float, rhi::Dimension::d2);
    const bool whole = drawn ? floats.color_attachment : floats.storage;
    setup.composite.target_format = whole ? rhi::Format::rgba32_float : rhi::Format::rgba16_float;
    setup.composite.raster = drawn;
    setup.composite.scene_color = setup.composite.scene_depth = true;
    PassPair pair(target, setup);
    pair.record_air();
    pair.share_air();
    CompositeTargets targets[2];  // of the checked device, of the CPU's
    for (CompositeTargets& each : targets) each.extent = {37, 23, 1};
    give_scene(*pair.checked, depth_format, targets[0]);
    give_scene(*pair.reference, depth_format, targets[1]);
    Difference light("radiance");
    for (const PlaceAndHour& place : places_and_hours) {
        const Context context(place.name());
        pair.record_view(passes::camera_at(setup.air.planet, place.altitude_m), passes::sun_at(place.elevation_deg));
        const PassPair::Tables pictures{pair.checked->show(targets[0], setup.composite.target_format, drawn),
                                        pair.reference->show(targets[1], setup.composite.target_format, drawn)};
        const std::string problem = passes::unsound(pictures.checked);
        expect(problem.empty(), "the picture holds " + problem);
        light.compare(pictures, 0, pictures.checked.extent.height, radiance, place.name());
    }
    // Half floats: where both round to other sides, a step of 2^-10 lies between them.
    light.tell(whole ? target.pass_tolerance : std::max(target.pass_tolerance, 0x1p-9));
}

}  // namespace

void check_composite(const Target& target) { check_picture(target, false); }

void check_composite_drawn(const Target& target) {
    if (!target.device.capabilities().raster) throw Skipped{"Capabilities::raster is false"};
    check_picture(target, true);
}

}  // namespace aureole::conformance
