#include "viewer/panels/panels.h"

namespace aureole::viewer {
namespace {

constexpr ImGuiTableFlags ruled = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;

struct Column {
    const char* title;
    float width;  ///< What ImGui would find out takes it some frames.
};

void header(std::initializer_list<Column> columns) {
    for (const Column& column : columns) ImGui::TableSetupColumn(column.title, ImGuiTableColumnFlags_WidthFixed, column.width);
    ImGui::TableHeadersRow();
}

template <class... Values>
void cell(const char* format, Values... values) {
    ImGui::TableNextColumn();
    ImGui::Text(format, values...);
}

void passes(const PanePicture& pane) {
    if (!ImGui::BeginTable("passes", 4, ruled)) return;
    header({{"pass", 150}, {"ms", 70}, {"invocations", 80}, {"KiB written", 80}});
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
    header({{"pipeline", 145}, {"ms", 50}, {"evaluations", 76}, {"samples", 60}, {"stores", 50}});
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
