#include "viewer/panels/panels.h"

namespace aureole::viewer {
namespace {

void edit_number(Session& session, const Field& field) {
    double value = field.number(session.state);
    ImGuiSliderFlags flags = ImGuiSliderFlags_NoRoundToFormat;
    if (field.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    // By powers of ten nothing begins at 0; that can be typed.
    const double least = field.logarithmic && field.least == 0 ? field.most * 1e-9 : field.least;
    // ImGui takes for zero what the format would not show of a fixed point number.
    const char* format = field.logarithmic && least < 1e-4 ? "%.9g" : "%.5g";
    if (ImGui::SliderScalar(field.label.c_str(), ImGuiDataType_Double, &value, &least, &field.most, format, flags))
        attempt(session, [&] { set_number(session.state, field, value); });
}

bool edit_flag(Session& session, const Field& field) {
    bool on = field.text(session.state) == "true";
    const bool changed = ImGui::Checkbox(field.label.c_str(), &on);
    session.marks.last(field.name);
    if (changed) attempt(session, [&] { set_text(session.state, field, on ? "true" : "false"); });
    return changed;
}

bool edit_choice(Session& session, const Field& field) {
    const std::string now = field.text(session.state);
    const bool open = ImGui::BeginCombo(field.label.c_str(), now.c_str());
    session.marks.last(field.name, true);
    if (!open) return false;
    bool changed = false;
    for (const std::string& option : field.options) {
        if (ImGui::Selectable(option.c_str(), option == now)) {
            attempt(session, [&] { set_text(session.state, field, option); });
            changed = true;
        }
        session.marks.last(field.name + "=" + option);
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace

bool edit_field(Session& session, const Field& field) {
    bool chosen = false;
    ImGui::PushID(field.name.c_str());
    if (field.is_number()) {
        edit_number(session, field);
        session.marks.last(field.name, true);
    } else if (field.is_flag()) {
        chosen = edit_flag(session, field);
    } else if (!field.options.empty()) {
        chosen = edit_choice(session, field);
    }
    ImGui::PopID();
    return chosen;
}

void edit_group(Session& session, const std::string& group) {
    ImGui::PushID(group.c_str());
    ImGui::PushItemWidth(180);
    for (const Field& field : fields_of(session.state, Rows::left_out))
        if (field.group == group && edit_field(session, field)) break;  // the rest may be of what is there no more
    ImGui::PopItemWidth();
    ImGui::PopID();
}

}  // namespace aureole::viewer
