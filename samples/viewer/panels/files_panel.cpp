#include "viewer/panels/panels.h"

namespace aureole::viewer {

void files_panel(Session& session) {
    ImGui::InputText("file", session.file.data(), session.file.size());
    session.marks.last("file", true);
    const auto button = [&](const char* label, auto action) {
        if (ImGui::Button(label)) attempt(session, action);
        session.marks.last(label);
    };
    const std::string name = session.file.data();
    button("Load scene", [&] { session.load(name); });
    ImGui::SameLine();
    button("Save scene", [&] {
        session.save(name);
        session.message = "wrote " + name;
    });
    ImGui::Separator();
    button("Save screenshot", [&] { session.screenshot_to = name; });
    ImGui::SameLine();
    button("Save picture", [&] { session.picture_to = name; });
    ImGui::Separator();
    if (session.recording) {
        ImGui::Text("recording: %.1f s, %zu places", session.path.length_s(), session.path.points().size());
        button("Stop and write path", [&] { session.stop_recording(name); });
    } else {
        button("Record path", [&] { session.start_recording(); });
        ImGui::SameLine();
        button("Play path", [&] { session.play(name); });
    }
    ImGui::Separator();
    ImGui::TextWrapped(
        "In the picture: drag with the left button to look around, with the right button to move the sun, in a split near its "
        "line to move that; the wheel changes the field of view. W A S D fly level, E up, Q down, shift five times as fast; "
        "the "
        "speed grows with the altitude.");
}

}  // namespace aureole::viewer
