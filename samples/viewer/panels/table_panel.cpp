#include "viewer/panels/panels.h"

#include <algorithm>
#include <cmath>

namespace aureole::viewer {
namespace {

ImU32 colour_of(const float* rgba, float scale) {
    const auto channel = [&](int c) {
        const float value = rgba[c] * scale;
        return std::isfinite(value) ? std::sqrt(std::clamp(value, 0.0F, 1.0F)) : 1.0F;
    };
    return ImGui::GetColorU32(ImVec4(channel(0), channel(1), channel(2), 1));
}

void choose(Session& session, const PanePicture& pane) {
    State& state = session.state;
    for (int i = 0; i < 2; ++i) {
        if (i > 0) ImGui::SameLine();
        ImGui::RadioButton(i == 0 ? "of pane A" : "of pane B", &state.table_pane, i);
        session.marks.last("view.table_pane=" + std::to_string(i));
    }
    const std::string now = pane.table ? pane.table->name : "none";
    const bool open = ImGui::BeginCombo("table", now.c_str());
    session.marks.last("view.table_name", true);
    if (open) {
        for (const std::string& name : pane.table_names) {
            if (ImGui::Selectable(name.c_str(), name == now)) {
                state.table_name = name;
                state.table_slice = 0;
            }
            session.marks.last("view.table_name=" + name);
        }
        ImGui::EndCombo();
    }
    if (pane.table && pane.table->slices > 1) {
        ImGui::SliderInt("slice", &state.table_slice, 0, pane.table->slices - 1);
        session.marks.last("view.table_slice", true);
    }
    ImGui::SliderFloat("brightness", &session.table_gain, 0.01F, 1000, "%.3g", ImGuiSliderFlags_Logarithmic);
}

/// Each texel a rectangle; the one under the mouse has its numbers below.
void show(Session& session, const TableSlice& table) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room_x = ImGui::GetContentRegionAvail().x, room_y = std::max(ImGui::GetContentRegionAvail().y - 90, 100.0F);
    const float w = static_cast<float>(table.width), h = static_cast<float>(table.height);
    const ImVec2 side{std::min(room_x / w, 24.0F), std::min(room_y / h, 24.0F)};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float scale = table.greatest > 0 ? session.table_gain / table.greatest : 0;
    for (std::uint32_t y = 0; y < table.height; ++y)
        for (std::uint32_t x = 0; x < table.width; ++x) {
            const ImVec2 corner{at.x + side.x * static_cast<float>(x), at.y + side.y * static_cast<float>(y)};
            draw->AddRectFilled(corner, {corner.x + side.x, corner.y + side.y}, colour_of(table.texel(x, y), scale));
        }
    ImGui::InvisibleButton("texels", {side.x * w, side.y * h});
    session.marks.last("texels");
    if (ImGui::IsItemHovered()) {
        const ImVec2 mouse = ImGui::GetMousePos();
        const int x = static_cast<int>((mouse.x - at.x) / side.x), y = static_cast<int>((mouse.y - at.y) / side.y);
        session.texel = std::array{std::clamp(x, 0, static_cast<int>(table.width) - 1),
                                   std::clamp(y, 0, static_cast<int>(table.height) - 1)};
    }
}

}  // namespace

void table_panel(Session& session) {
    const PanePicture* pane = session.pane(session.state.table_pane);
    if (!pane) {
        ImGui::TextWrapped("This pane is not shown.");
        return;
    }
    choose(session, *pane);
    if (!pane->table) {
        ImGui::TextWrapped("%s", pane->table_names.empty() ? "This model keeps no table." : "Reading...");
        return;
    }
    const TableSlice& table = *pane->table;
    ImGui::Text("%ux%u, slices: %d, %s, greatest %.5g", table.width, table.height, table.slices, rhi::to_string(table.format),
                static_cast<double>(table.greatest));
    show(session, table);
    if (!session.texel) return;
    const auto x = static_cast<std::uint32_t>((*session.texel)[0]), y = static_cast<std::uint32_t>((*session.texel)[1]);
    if (x >= table.width || y >= table.height) return;
    const float* t = table.texel(x, y);
    ImGui::Text("texel %u, %u of slice %d", x, y, table.slice);
    ImGui::Text("r %.6g  g %.6g  b %.6g  a %.6g", static_cast<double>(t[0]), static_cast<double>(t[1]),
                static_cast<double>(t[2]), static_cast<double>(t[3]));
}

}  // namespace aureole::viewer
