#include "viewer/core/field_builder.h"

#include <array>

namespace aureole::viewer {
namespace {

constexpr std::array<const char*, 3> projections{"perspective", "fisheye", "panorama"};
constexpr std::array<Projection, 3> kinds{Projection::matrix, Projection::fisheye, Projection::panorama};

void add_camera(FieldBuilder& add, const State& state) {
    add.group("camera", "camera.");
    if (state.scene.camera.clearance_m)
        add.number(
            "clearance_m", "above the land (m)", {0, 1e6, true}, [](auto& s) -> auto& { return *s.scene.camera.clearance_m; });
    else
        add.number(
            "altitude_m", "altitude (m)", {0, 1e9, true}, [](auto& s) -> auto& { return s.scene.camera.altitude_m; });
    add.number(
        "bearing_deg", "bearing (deg)", {-360, 360}, [](auto& s) -> auto& { return s.scene.camera.pose.bearing_deg; });
    add.number(
        "elevation_deg", "elevation (deg)", {-90, 90}, [](auto& s) -> auto& { return s.scene.camera.pose.elevation_deg; });
    add.number(
        "vertical_fov_deg", "field of view, vertical (deg)", {0.01, 170},
        [](auto& s) -> auto& { return s.scene.camera.vertical_fov_deg; });
    std::vector<std::string> allowed(projections.begin(), projections.end());
    if (state.scene.terrain) allowed.resize(1);  // the others have no depth
    add.text(
        "projection", "projection", allowed,
        [](const State& s) -> std::string {
            return projections[s.scene.camera.projection == Projection::matrix    ? 0
                               : s.scene.camera.projection == Projection::fisheye ? 1
                                                                                  : 2];
        },
        [](State& s, const std::string& name) {
            for (std::size_t i = 0; i < kinds.size(); ++i)
                if (name == projections[i]) s.scene.camera.projection = kinds[i];
        });
}

void add_picture(FieldBuilder& add, const State& state) {
    add.group("picture", "picture.");
    add.text(
        "exposure", "exposure", {"auto", "fixed"},
        [](const State& s) -> std::string { return s.scene.exposure.factor ? "fixed" : "auto"; },
        [](State& s, const std::string& value) {
            if (value == "auto")
                s.scene.exposure.factor.reset();
            else if (!s.scene.exposure.factor)
                s.scene.exposure.factor = 10;
        });
    if (state.scene.exposure.factor)
        add.number(
            "exposure_factor", "factor on radiance", {1e-9, 1e12, true},
            [](auto& s) -> auto& { return *s.scene.exposure.factor; });
    add.number(
        "exposure_stops", "exposure (stops)", {-30, 30}, [](auto& s) -> auto& { return s.scene.exposure.stops; });
    add.flag(
        "sun_disk", "suns are shown", [](auto& s) -> auto& { return s.scene.sun_disk; });
    add.number(
        "sun_lobe_g", "lobe in place of disks, g", {0, 0.9999}, [](auto& s) -> auto& { return s.scene.sun_lobe_g; });
    add.number(
        "aerial_perspective_distance_m", "froxels reach (m)", {1, 1e9, true},
        [](auto& s) -> auto& { return s.scene.aerial_perspective_distance_m; });
}

void add_suns(FieldBuilder& add, const State& state) {
    add.group("suns", "");
    add.text(
        "suns", "number of suns", {"0", "1", "2", "3", "4"}, [](const State& s) { return std::to_string(s.scene.suns.size()); },
        [](State& s, const std::string& value) { s.scene.suns.resize(static_cast<std::size_t>(value[0] - '0')); });
    for (std::size_t i = 0; i < state.scene.suns.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        add.group("sun " + number, "sun." + number + ".");
        add.number(
            "elevation_deg", "elevation (deg)",
            {-90, 90}, [i](auto& s) -> auto& { return s.scene.suns[i].pose.elevation_deg; });
        add.number(
            "bearing_deg", "bearing (deg)", {-360, 360}, [i](auto& s) -> auto& { return s.scene.suns[i].pose.bearing_deg; });
        add.text(
            "colour", "irradiance", {"sun", "given"},
            [i](const State& s) -> std::string { return s.scene.suns[i].irradiance ? "given" : "sun"; },
            [i](State& s, const std::string& value) {
                if (value == "sun")
                    s.scene.suns[i].irradiance.reset();
                else if (!s.scene.suns[i].irradiance)
                    s.scene.suns[i].irradiance = Rgb(1);
            });
        if (state.scene.suns[i].irradiance)
            add.colour(
                "irradiance", "irradiance (unit of your own)",
                {0, 1e9, true}, [i](auto& s) -> auto& { return *s.scene.suns[i].irradiance; });
        add.number(
            "angular_radius_deg", "angular radius (deg)",
            {0, 45, true}, [i](auto& s) -> auto& { return s.scene.suns[i].angular_radius_deg; });
        add.text(
            "limb_darkening", "limb darkening", {"none", "neckel94"},
            [i](const State& s) -> std::string {
                return s.scene.suns[i].limb_darkening == LimbDarkening::none ? "none" : "neckel94";
            },
            [i](State& s, const std::string& value) {
                s.scene.suns[i].limb_darkening = value == "none" ? LimbDarkening::none : LimbDarkening::neckel94;
            });
    }
}

void add_terrain(FieldBuilder& add, const State& state) {
    add.group("terrain", "terrain.");
    std::vector<std::string> maps{"none", "jacksboro"};
    if (state.scene.terrain && state.scene.terrain->height_map != "jacksboro")
        maps.push_back(state.scene.terrain->height_map.string());
    add.text(
        "heightmap", "height map", maps,
        [](const State& s) -> std::string { return s.scene.terrain ? s.scene.terrain->height_map.string() : "none"; },
        [](State& s, const std::string& value) {
            if (value == "none") {
                s.scene.terrain.reset();
                s.scene.camera.clearance_m.reset();
            } else if (!s.scene.terrain || s.scene.terrain->height_map != value) {
                s.scene.terrain.emplace().height_map = value;
                s.scene.terrain->height_map_key = "terrain.heightmap";
                s.scene.camera.projection = Projection::matrix;
                s.scene.camera.clearance_m = 250;
            }
        });
    if (!state.scene.terrain) return;
    add.number(
        "vertical_exaggeration", "heights times", {0.01, 100, true},
        [](auto& s) -> auto& { return s.scene.terrain->vertical_exaggeration; });
    add.number(
        "camera_east_m", "camera east of the middle (m)", {-1e6, 1e6},
        [](auto& s) -> auto& { return s.scene.terrain->camera_east_m; });
    add.number(
        "camera_north_m", "camera north of the middle (m)", {-1e6, 1e6},
        [](auto& s) -> auto& { return s.scene.terrain->camera_north_m; });
    add.number(
        "range_m", "land reaches (m)", {100, 1e6, true}, [](auto& s) -> auto& { return s.scene.terrain->range_m; });
    add.number(
        "air_shadows_m", "shadows in the air reach (m)", {0, 1e6, true},
        [](auto& s) -> auto& { return s.scene.terrain->air_shadows_m; });
    add.text(
        "colour", "albedo", {"natural", "given"},
        [](const State& s) -> std::string { return s.scene.terrain->albedo ? "given" : "natural"; },
        [](State& s, const std::string& value) {
            if (value == "natural")
                s.scene.terrain->albedo.reset();
            else if (!s.scene.terrain->albedo)
                s.scene.terrain->albedo = Rgb(0.2);
        });
    if (state.scene.terrain->albedo)
        add.colour(
            "albedo", "albedo", {0, 1}, [](auto& s) -> auto& { return *s.scene.terrain->albedo; });
}

}  // namespace

void add_scene_fields(FieldBuilder& add, const State& state) {
    add_camera(add, state);
    add_picture(add, state);
    add_suns(add, state);
    add_terrain(add, state);
}

}  // namespace aureole::viewer
