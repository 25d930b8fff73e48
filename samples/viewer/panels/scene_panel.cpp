#include "viewer/panels/panels.h"

#include <algorithm>

namespace aureole::viewer {

void scene_panel(Session& session) {
    const auto part = [&](const std::string& title, const std::string& group, bool open) {
        if (ImGui::CollapsingHeader(title.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) edit_group(session, group);
        session.marks.last("part." + group);
    };
    part("Camera", "camera", true);
    ImGui::CollapsingHeader("Suns", ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_Leaf);
    edit_group(session, "suns");
    for (std::size_t i = 0; i < session.state.scene.suns.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        part("Sun " + number, "sun " + number, i == 0);
    }
    part("Picture", "picture", false);
    part("Terrain", "terrain", false);
}

void air_panel(Session& session) {
    if (ImGui::CollapsingHeader("Planet", ImGuiTreeNodeFlags_DefaultOpen)) edit_group(session, "planet");
    // By number: fields carry names, of which two could be the same while one is typed.
    std::optional<std::size_t> remove;
    for (std::size_t i = 0; i < session.state.scene.atmosphere.terms.size(); ++i) {
        const std::string name = session.state.scene.atmosphere.terms[i].name;
        ImGui::PushID(static_cast<int>(i));
        const bool open = ImGui::CollapsingHeader(("Term: " + name).c_str(), i == 0 ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        session.marks.last("part.term " + name);
        if (open) {
            edit_group(session, "term " + name);
            edit_samples(session, i);  // of the state as it is by now
            if (ImGui::Button("Take this term out")) remove = i;
            session.marks.last("remove " + name);
        }
        ImGui::PopID();
    }
    std::vector<DensityTerm>& terms = session.state.scene.atmosphere.terms;
    if (remove) terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(*remove));
    if (ImGui::Button("Add a term")) {
        DensityTerm term;
        for (int i = 1; term.name.empty(); ++i) {
            const std::string name = "term" + std::to_string(i);
            if (std::ranges::find(terms, name, &DensityTerm::name) == terms.end()) term.name = name;
        }
        term.scattering_per_m = Rgb(1e-6);
        terms.push_back(std::move(term));
    }
    session.marks.last("add term");
}

}  // namespace aureole::viewer
