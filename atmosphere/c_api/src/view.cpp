#include <aureole/light.h>

#include "convert.h"
#include "handles.h"

using namespace aureole;
using namespace aureole::c_api;

aureole_view::aureole_view(aureole_atmosphere& of, const ViewSettings& settings, const CompositeSettings& composite)
    : atmosphere(of), view(of.air, settings, composite) {
    ++atmosphere.views;
}
aureole_view::~aureole_view() { --atmosphere.views; }

namespace {

LightTable light_table(const float* texels, std::uint32_t count) { return LightTable({&given(texels, "texels"), count}); }

/// An index that does not fit an int is out of range all the same.
int index_of(std::uint32_t index) { return index > 1000 ? 1000 : static_cast<int>(index); }

}  // namespace

aureole_result aureole_view_settings_defaults(aureole_view_settings* settings) {
    return guarded([&] { write(settings, "settings", to_c(ViewSettings{})); });
}

aureole_result aureole_composite_settings_defaults(aureole_composite_settings* settings) {
    return guarded([&] { write(settings, "settings", to_c(CompositeSettings{})); });
}

aureole_result aureole_create_view(aureole_atmosphere* atmosphere, const aureole_view_settings* settings,
                                   const aureole_composite_settings* composite, aureole_view** out_view) {
    return guarded([&] {
        aureole_atmosphere& of = given(atmosphere, "atmosphere");
        const aureole_view_settings usual = to_c(ViewSettings{});
        const aureole_composite_settings usual_composite = to_c(CompositeSettings{});
        const ViewSettings tables = to_cpp(settings ? read(settings, "settings", usual) : usual);
        const CompositeSettings shown = to_cpp(composite ? read(composite, "composite", usual_composite) : usual_composite);
        aureole_view*& out = given(out_view, "out_view");
        out = new aureole_view(of, tables, shown);
    });
}

aureole_result aureole_destroy_view(aureole_view* view) {
    return guarded([&] { delete view; });
}

aureole_result aureole_camera_defaults(aureole_camera* camera) {
    return guarded([&] { write(camera, "camera", to_c(Camera{})); });
}

aureole_result aureole_look(double bottom_radius_m, double altitude_m, double azimuth_rad, double elevation_rad,
                            double vertical_fov_rad, double aspect, double near_m, aureole_camera* out_camera) {
    return guarded([&] {
        const Camera camera = look(bottom_radius_m, altitude_m, azimuth_rad, elevation_rad, vertical_fov_rad, aspect, near_m);
        write(out_camera, "out_camera", to_c(camera));
    });
}

aureole_result aureole_sun_defaults(aureole_sun* sun) {
    return guarded([&] { write(sun, "sun", to_c(Sun{})); });
}

aureole_result aureole_update_view(aureole_view* view, const aureole_camera* camera, const aureole_sun* suns,
                                   uint32_t sun_count) {
    return guarded([&] {
        View& of = given(view, "view").view;
        of.update(to_cpp(read(camera, "camera", to_c(Camera{}))), read_suns(suns, sun_count));
    });
}

aureole_result aureole_envelope_of_view(const aureole_view* view, const aureole_camera* camera, const aureole_sun* suns,
                                        uint32_t sun_count, aureole_outside* out, uint32_t capacity, uint32_t* out_count) {
    return guarded([&] {
        const aureole_view& of = given(view, "view");
        const Camera at = to_cpp(read(camera, "camera", to_c(Camera{})));
        const std::vector<Sun> lights = read_suns(suns, sun_count);
        validate(at);
        for (const Sun& sun : lights) validate(sun);
        write_outside(outside_envelope(of.atmosphere.air.parameters().planet, at, lights), out, capacity, out_count);
    });
}

aureole_result aureole_set_exposure(aureole_view* view, double exposure) {
    return guarded([&] { given(view, "view").view.set_exposure(exposure); });
}

aureole_result aureole_shadow_map_defaults(aureole_shadow_map* map) {
    return guarded([&] { write(map, "map", to_c(ShadowMap{})); });
}

aureole_result aureole_set_shadow_map(aureole_view* view, const aureole_shadow_map* map) {
    return guarded([&] { given(view, "view").view.set_shadow_map(to_cpp(read(map, "map", to_c(ShadowMap{})))); });
}

aureole_result aureole_composite_targets_defaults(aureole_composite_targets* targets) {
    return guarded([&] { write(targets, "targets", to_c(CompositeTargets{})); });
}

aureole_result aureole_prepare_composite(aureole_view* view, const aureole_composite_targets* targets) {
    return guarded([&] { given(view, "view").view.prepare_composite(read_targets(targets)); });
}

aureole_result aureole_release_composite(aureole_view* view, const aureole_composite_targets* targets) {
    return guarded([&] { given(view, "view").view.release_composite(read_targets(targets)); });
}

aureole_result aureole_record_view(aureole_view* view, aureole_commands* commands, int32_t first_timestamp) {
    return guarded([&] {
        aureole_view& of = given(view, "view");
        of.view.record(open_list(of.atmosphere.device, commands), timestamps(first_timestamp));
    });
}

aureole_result aureole_record_composite(aureole_view* view, aureole_commands* commands,
                                        const aureole_composite_targets* targets, int32_t first_timestamp) {
    return guarded([&] {
        aureole_view& of = given(view, "view");
        of.view.record_composite(open_list(of.atmosphere.device, commands), read_targets(targets), timestamps(first_timestamp));
    });
}

aureole_result aureole_invalidate_view(aureole_view* view) {
    return guarded([&] { given(view, "view").view.invalidate(); });
}

aureole_result aureole_view_reports(const aureole_view* view, aureole_pass_report* out, uint32_t capacity,
                                    uint32_t* out_count) {
    return guarded([&] { write_reports(given(view, "view").view.reports(), out, capacity, out_count); });
}

aureole_result aureole_view_table_bytes(const aureole_view* view, uint64_t* out_bytes) {
    return guarded([&] { given(out_bytes, "out_bytes") = given(view, "view").view.table_bytes(); });
}

aureole_result aureole_shader_defines(const aureole_view* view, const char** out_defines) {
    return guarded([&] {
        thread_local std::string latest;
        const char*& out = given(out_defines, "out_defines");
        latest = given(view, "view").view.shader_defines();
        out = latest.c_str();
    });
}

aureole_result aureole_get_view_tables(const aureole_view* view, aureole_view_tables* out_tables) {
    return guarded([&] {
        const View& v = given(view, "view").view;
        const Atmosphere& air = view->atmosphere.air;
        write(out_tables, "out_tables",
              {sizeof(aureole_view_tables), air.transmittance_table().value, air.multi_scatter_table().value,
               v.sky_view_table().value, v.aerial_perspective_table().value, v.light_table().value, v.phase_table().value,
               v.profile_table().value, v.view_block().value, v.air_block().value});
    });
}

aureole_result aureole_sun_irradiance(const float* texels, uint32_t count, uint32_t sun, double out_rgb[3]) {
    return guarded([&] { copy(light_table(texels, count).sun_irradiance(index_of(sun)), &given(out_rgb, "out_rgb")); });
}

aureole_result aureole_sky_irradiance(const float* texels, uint32_t count, const double normal[3], double out_rgb[3]) {
    return guarded(
        [&] { copy(light_table(texels, count).sky_irradiance(rgb(&given(normal, "normal"))), &given(out_rgb, "out_rgb")); });
}

aureole_result aureole_sky_coefficient(const float* texels, uint32_t count, uint32_t index, uint32_t sun, double out_rgb[3]) {
    return guarded(
        [&] { copy(light_table(texels, count).sky_coefficient(index_of(index), index_of(sun)), &given(out_rgb, "out_rgb")); });
}
