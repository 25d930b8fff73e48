#include "viewer/panels/panels.h"

#include <algorithm>
#include <string_view>

namespace aureole::viewer {
namespace {

void setup(Session& session, int index) {
    const std::string letter = index == 0 ? "a" : "b";
    if (!ImGui::CollapsingHeader(index == 0 ? "Pane A" : "Pane B", ImGuiTreeNodeFlags_DefaultOpen)) return;
    edit_group(session, "pane " + letter);
    const PanePicture* pane = session.pane(index);
    if (!pane) return;
    ImGui::TextWrapped("%s", pane->backend.c_str());
    ImGui::Text("%s", pane->model.c_str());
    ImGui::Text("%ux%u pixels, %.0f ms, exposure %.4g, tables %.2f MiB", pane->display.width, pane->display.height,
                pane->milliseconds, pane->exposure, static_cast<double>(pane->table_bytes) / (1 << 20));
    if (pane->plan.empty()) return;
    const bool open = ImGui::TreeNode(("Why this plan?##" + letter).c_str());
    session.marks.last(letter + ".plan");
    if (!open) return;
    ImGui::TextWrapped("%s", pane->plan.c_str());
    ImGui::TreePop();
}

/// The false colours and what they stand for.
void legend(double range) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    constexpr int steps = 128;
    constexpr float width = 360, height = 14;
    for (int i = 0; i < steps; ++i) {
        const double relative = range * (2.0 * i / (steps - 1) - 1);
        const auto c = false_colour(relative, range);
        const float x = at.x + width * static_cast<float>(i) / steps;
        draw->AddRectFilled({x, at.y}, {x + width / steps + 1, at.y + height}, IM_COL32(c[0], c[1], c[2], 255));
    }
    ImGui::Dummy({width, height});
    ImGui::Text("-%.3g %%", 100 * range);
    ImGui::SameLine(width / 2);
    ImGui::Text("0");
    ImGui::SameLine(width - 30);
    ImGui::Text("+%.3g %%", 100 * range);
    ImGui::TextWrapped("(B - A) / A in luminance. Black: none. Red to white: B is brighter; blue to white: darker.");
}

}  // namespace

void panes_panel(Session& session) {
    const std::vector<Field> fields = fields_of(session.state, Rows::left_out);
    static constexpr const char* labels[] = {"A", "B", "A | B", "Difference"};
    for (std::size_t i = 0; i < layout_names().size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const auto layout = static_cast<Layout>(i);
        if (ImGui::RadioButton(labels[i], session.state.layout == layout)) session.state.layout = layout;
        session.marks.last("view.layout=" + std::string(layout_names()[i]));
    }
    for (const Field& field : fields) {
        static constexpr std::array<std::string_view, 4> here{"view.resolution", "view.labels", "view.divider",
                                                              "view.difference_range"};
        if (std::ranges::find(here, field.name) != here.end()) {
            ImGui::PushItemWidth(180);
            edit_field(session, field);
            ImGui::PopItemWidth();
        }
    }
    if (session.state.layout == Layout::difference) {
        legend(session.state.difference_range);
        if (session.apart)
            ImGui::Text("median %.3g %%, 95 of 100 below %.3g %%, greatest %.3g %%", 100 * session.apart->median,
                        100 * session.apart->p95, 100 * session.apart->greatest);
    }
    setup(session, 0);
    setup(session, 1);
}

}  // namespace aureole::viewer
