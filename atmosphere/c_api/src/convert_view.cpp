#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "convert.h"

namespace aureole::c_api {
namespace {

glm::dmat4 matrix(const double from[16]) { return glm::make_mat4(from); }
void copy_matrix(const glm::dmat4& from, double to[16]) { std::copy_n(glm::value_ptr(from), 16, to); }

std::optional<double> if_given(double value) { return value == 0 ? std::nullopt : std::optional(value); }

// Numbers in C are those of C++.
static_assert(number(Projection::panorama) == AUREOLE_PROJECTION_PANORAMA);
static_assert(number(Projection::fisheye) == AUREOLE_PROJECTION_FISHEYE);
static_assert(number(DepthRange::minus_one_to_one) == AUREOLE_DEPTH_MINUS_ONE_TO_ONE);
static_assert(number(RowOrder::bottom_first) == AUREOLE_ROWS_BOTTOM_FIRST);
static_assert(number(ToneMap::aces_fitted) == AUREOLE_TONE_MAP_ACES_FITTED);
static_assert(number(LimbDarkening::neckel94) == AUREOLE_LIMB_NECKEL94);
static_assert(ShadowSettings::max_cascades == 4);

Sun to_cpp(const aureole_sun& c) {
    Sun sun;
    sun.direction = rgb(c.direction);
    sun.irradiance = rgb(c.irradiance);
    sun.angular_radius_rad = c.angular_radius_rad;
    sun.limb_darkening = enumerator(c.limb_darkening, LimbDarkening::neckel94, "sun.limb_darkening");
    return sun;
}

}  // namespace

TimestampSlots timestamps(std::int32_t first) {
    if (first < -1) throw Error(ErrorCode::invalid_argument, "first_timestamp", std::to_string(first), "-1 or more");
    return {first >= 0, first >= 0 ? static_cast<std::uint32_t>(first) : 0};
}

void write_reports(std::span<const PassReport> reports, aureole_pass_report* out, std::uint32_t capacity,
                   std::uint32_t* out_count) {
    write_all<aureole_pass_report>(out, capacity, out_count, "out", reports.size(), [&](std::size_t i) {
        const PassReport& report = reports[i];  // names are literals
        return aureole_pass_report{sizeof(aureole_pass_report), report.recorded, report.name.data(), report.invocations,
                                   report.bytes_written};
    });
}

aureole_view_settings to_c(const ViewSettings& s) {
    aureole_view_settings c{};
    c.struct_size = sizeof c;
    c.projection = number(s.projection);
    c.max_suns = s.max_suns;
    c.aerial_perspective = s.aerial_perspective;
    c.aerial_perspective_distance_m = s.aerial_perspective_distance_m;
    c.light = s.light;
    c.shadow_cascades = s.shadows.cascades;
    c.shadow_distance_m = s.shadows.distance_m;
    c.shadow_size[0] = s.shadows.size.width, c.shadow_size[1] = s.shadows.size.height, c.shadow_size[2] = s.shadows.size.depth;
    c.shadow_samples = s.shadows.samples;
    return c;
}

ViewSettings to_cpp(const aureole_view_settings& c) {
    ViewSettings s;
    s.projection = enumerator(c.projection, Projection::fisheye, "view.projection");
    s.max_suns = c.max_suns;
    s.aerial_perspective = boolean(c.aerial_perspective, "view.aerial_perspective");
    s.aerial_perspective_distance_m = c.aerial_perspective_distance_m;
    s.light = boolean(c.light, "view.light");
    s.shadows = {
        c.shadow_cascades, c.shadow_distance_m, {c.shadow_size[0], c.shadow_size[1], c.shadow_size[2]}, c.shadow_samples};
    return s;
}

aureole_composite_settings to_c(const CompositeSettings& s) {
    aureole_composite_settings c{};
    c.struct_size = sizeof c;
    c.target_format = number(s.target_format);
    c.raster = s.raster;
    c.scene_color = s.scene_color;
    c.scene_depth = s.scene_depth;
    c.sun_disk = s.sun_disk;
    c.sun_lobe_g = s.sun_lobe_g;
    c.exposure = s.exposure;
    c.tone_map = number(s.tone_map);
    c.encode_srgb = s.encode_srgb;
    c.dither = s.dither;
    return c;
}

CompositeSettings to_cpp(const aureole_composite_settings& c) {
    CompositeSettings s;
    s.target_format = enumerator(c.target_format, rhi::Format::d32_float, "composite.target_format");
    s.raster = boolean(c.raster, "composite.raster");
    s.scene_color = boolean(c.scene_color, "composite.scene_color");
    s.scene_depth = boolean(c.scene_depth, "composite.scene_depth");
    s.sun_disk = boolean(c.sun_disk, "composite.sun_disk");
    s.sun_lobe_g = c.sun_lobe_g;
    s.exposure = c.exposure;
    s.tone_map = enumerator(c.tone_map, ToneMap::aces_fitted, "composite.tone_map");
    s.encode_srgb = boolean(c.encode_srgb, "composite.encode_srgb");
    s.dither = boolean(c.dither, "composite.dither");
    return s;
}

aureole_camera to_c(const Camera& camera) {
    aureole_camera c{};
    c.struct_size = sizeof c;
    c.kind = number(camera.kind);
    c.depth_range = number(camera.depth_range);
    c.row_order = number(camera.row_order);
    copy(camera.position_m, c.position_m);
    copy_matrix(camera.view, c.view);
    copy_matrix(camera.projection, c.projection);
    return c;
}

Camera to_cpp(const aureole_camera& c) {
    Camera camera;
    camera.position_m = rgb(c.position_m);
    camera.view = matrix(c.view);
    camera.projection = matrix(c.projection);
    camera.kind = enumerator(c.kind, Projection::fisheye, "camera.kind");
    camera.depth_range = enumerator(c.depth_range, DepthRange::minus_one_to_one, "camera.depth_range");
    camera.row_order = enumerator(c.row_order, RowOrder::bottom_first, "camera.row_order");
    return camera;
}

aureole_sun to_c(const Sun& sun) {
    aureole_sun c{};
    c.struct_size = sizeof c;
    c.limb_darkening = number(sun.limb_darkening);
    copy(sun.direction, c.direction);
    copy(sun.irradiance, c.irradiance);
    c.angular_radius_rad = sun.angular_radius_rad;
    return c;
}

std::vector<Sun> read_suns(const aureole_sun* suns, std::uint32_t count) {
    std::vector<Sun> read_ones;
    if (count == 0) return read_ones;
    const aureole_sun usual = to_c(Sun{});
    check_size<aureole_sun>(given(suns, "suns").struct_size, "suns[0]");
    for (std::uint32_t i = 0; i < count; ++i) {
        aureole_sun sun = usual;
        std::memcpy(&sun, element(suns, i), suns->struct_size);
        read_ones.push_back(to_cpp(sun));
    }
    return read_ones;
}

aureole_shadow_map to_c(const ShadowMap& map) {
    aureole_shadow_map c{};
    c.struct_size = sizeof c;
    c.sun = map.sun;
    c.texture = map.texture.value;
    for (std::size_t i = 0; i < map.world_to_map.size(); ++i) copy_matrix(map.world_to_map[i], c.world_to_map[i]);
    c.bias = map.bias;
    c.reversed = map.reversed;
    return c;
}

ShadowMap to_cpp(const aureole_shadow_map& c) {
    ShadowMap map;
    map.texture = {c.texture};
    for (std::size_t i = 0; i < map.world_to_map.size(); ++i) map.world_to_map[i] = matrix(c.world_to_map[i]);
    map.sun = c.sun;
    map.reversed = boolean(c.reversed, "shadow_map.reversed");
    map.bias = c.bias;
    return map;
}

aureole_composite_targets to_c(const CompositeTargets& targets) {
    return {sizeof(aureole_composite_targets), targets.extent.width,      targets.extent.height,
            targets.scene_color.value,         targets.scene_depth.value, targets.target.value};
}

CompositeTargets to_cpp(const aureole_composite_targets& c) {
    CompositeTargets targets;
    targets.scene_color = {c.scene_color};
    targets.scene_depth = {c.scene_depth};
    targets.target = {c.target};
    targets.extent = {c.width, c.height, 1};
    return targets;
}

CompositeTargets read_targets(const aureole_composite_targets* targets) {
    return to_cpp(read(targets, "targets", to_c(CompositeTargets{})));
}

aureole_requirements to_c(const PlanRequirements& needs) {
    aureole_requirements c{};
    c.struct_size = sizeof c;
    c.projection = number(needs.projection);
    c.sun_elevation_deg[0] = needs.sun_elevation_deg.least, c.sun_elevation_deg[1] = needs.sun_elevation_deg.most;
    c.altitude_m[0] = needs.altitude_m.least, c.altitude_m[1] = needs.altitude_m.most;
    c.geometry_range_m = needs.geometry_range_m;
    c.geometry = needs.geometry;
    c.shadows = needs.shadows;
    c.light = needs.light;
    c.suns = needs.suns;
    c.views = needs.views;
    c.width = needs.width, c.height = needs.height;
    c.wavelengths = needs.wavelengths;
    c.rebuilds_per_frame = needs.rebuilds_per_frame;
    c.tolerance = needs.tolerance.value_or(0);
    c.budget_ms = needs.budget_ms.value_or(0);
    c.budget_mib = needs.budget_mib.value_or(0);
    c.speed_composite = needs.speed.composite;
    c.speed_tables = needs.speed.tables;
    return c;
}

PlanRequirements to_cpp(const aureole_requirements& c) {
    PlanRequirements needs;
    needs.air = read_parameters(c.air, "air");
    needs.sun_elevation_deg = {c.sun_elevation_deg[0], c.sun_elevation_deg[1]};
    needs.altitude_m = {c.altitude_m[0], c.altitude_m[1]};
    needs.projection = enumerator(c.projection, Projection::fisheye, "projection");
    needs.geometry = boolean(c.geometry, "geometry");
    needs.geometry_range_m = c.geometry_range_m;
    needs.shadows = boolean(c.shadows, "shadows");
    needs.light = boolean(c.light, "light");
    needs.suns = c.suns;
    needs.views = c.views;
    needs.width = c.width, needs.height = c.height;
    needs.wavelengths = boolean(c.wavelengths, "wavelengths");
    needs.rebuilds_per_frame = c.rebuilds_per_frame;
    needs.tolerance = if_given(c.tolerance);
    needs.budget_ms = if_given(c.budget_ms);
    needs.budget_mib = if_given(c.budget_mib);
    needs.speed = {c.speed_composite, c.speed_tables};
    return needs;
}

aureole_setting default_setting() { return {sizeof(aureole_setting), 0, nullptr, nullptr, nullptr, nullptr, nullptr, 0}; }

Setting read_setting(const aureole_setting* setting) {
    Setting chosen;
    if (!setting) return chosen;
    const aureole_setting c = read(setting, "setting", default_setting());
    if (c.model) chosen.model = c.model;
    if (c.quality) chosen.quality = c.quality;
    if (c.spectral) chosen.spectral = c.spectral;
    if (c.without_count > 0) given(c.without, "setting.without");
    for (std::uint32_t i = 0; i < c.without_count; ++i) chosen.without.emplace_back(&given(c.without[i], "setting.without"));
    return chosen;
}

}  // namespace aureole::c_api
