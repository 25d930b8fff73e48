#include "viewer/panels/panels.h"

#include "scene/write_scene.h"

namespace aureole::viewer {

void Session::load(const std::filesystem::path& path_of_scene) {
    const app::Scene scene = app::read_scene(path_of_scene);
    state.scene = scene;
    for (PaneSetup& setup : state.panes) setup.model = scene.model;
    message = "read " + path_of_scene.string();
}

void Session::save(const std::filesystem::path& path_of_scene) const { app::write_scene(path_of_scene, scene_of(state)); }

void Session::start_recording() {
    path = {};
    recording = true;
    recorded_s = 0;
    playing_s.reset();
    message = "recording";
}

void Session::stop_recording(const std::filesystem::path& path_of_csv) {
    recording = false;
    path.add(point_of(state.scene, altitude_m(), recorded_s));
    write_path(path_of_csv, path);
    message = "wrote " + path_of_csv.string() + ": " + std::to_string(path.points().size()) + " places";
}

void Session::play(const std::filesystem::path& path_of_csv) {
    Path read = read_path(path_of_csv);
    path = std::move(read);
    recording = false;
    playing_s = 0;
}

double Session::ground_m() const {
    const PanePicture* drawn_pane = pane(0) ? pane(0) : pane(1);
    return state.scene.terrain && drawn_pane ? drawn_pane->ground_m : 0;
}

double Session::altitude_m() const {
    const app::SceneCamera& camera = state.scene.camera;
    return camera.clearance_m ? ground_m() + *camera.clearance_m : camera.altitude_m;
}

const PanePicture* Session::pane(int index) const {
    const std::optional<PanePicture>& picture = shown.panes[static_cast<std::size_t>(index)];
    return picture ? &*picture : nullptr;
}

}  // namespace aureole::viewer
