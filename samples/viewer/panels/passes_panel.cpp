#include "viewer/panels/panels.h"

namespace aureole::viewer {
namespace {

constexpr ImGuiTableFlags ruled = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;

void header(std::initializer_list<const char*> titles) {
    for (const char* title : titles) ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
}

template <class... Values>
void cell(const char* format, Values... values) {
    ImGui::TableNextColumn();
    ImGui::Text(format, values...);
}

void passes(const PanePicture& pane) {
    if (!ImGui::BeginTable("passes", 4, ruled)) return;
    header({"pass", "ms", "invocations", "KiB written"});
    for (const PassFigure& pass : pane.passes) {
        if (!pass.recorded) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        cell("%s", pass.name.c_str());
        cell("%.3f", pass.milliseconds);
        cell("%llu", static_cast<unsigned long long>(pass.invocations));
        cell("%.0f", static_cast<double>(pass.bytes_written) / 1024);
        if (!pass.recorded) ImGui::PopStyleColor();
    }
    ImGui::EndTable();
}

void work(const PanePicture& pane) {
    if (pane.work.empty() || !ImGui::BeginTable("work", 5, ruled)) return;
    header({"pipeline", "ms", "evaluations", "samples", "stores"});
    for (const cpu::PipelineWork& w : pane.work) {
        cell("%s", w.pipeline.c_str());
        cell("%.3f", w.seconds * 1e3);
        cell("%llu", static_cast<unsigned long long>(w.counts.evaluations));
        cell("%llu", static_cast<unsigned long long>(w.counts.samples));
        cell("%llu", static_cast<unsigned long long>(w.counts.stores));
    }
    ImGui::EndTable();
}

}  // namespace

void passes_panel(Session& session) {
    ImGui::TextWrapped(
        "Times are of the device's clock, milliseconds. Grey: nothing to do for the latest picture, figures of an earlier "
        "one.");
    for (int i = 0; i < 2; ++i) {
        const PanePicture* pane = session.pane(i);
        if (!pane) continue;
        ImGui::PushID(i);
        if (ImGui::CollapsingHeader(i == 0 ? "Pane A" : "Pane B", ImGuiTreeNodeFlags_DefaultOpen)) {
            ImGui::Text("%s", pane->model.c_str());
            passes(*pane);
            work(*pane);
        }
        ImGui::PopID();
    }
}

}  // namespace aureole::viewer
