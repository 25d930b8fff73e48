#include "viewer/panels/panels.h"

#include <algorithm>

namespace aureole::viewer {
namespace {

/// "term.mie.profile.insert.2" for the marks.
bool button(Session& session, const char* text, const std::string& name) {
    ImGui::SameLine();
    ImGui::PushID(name.c_str());
    const bool pressed = ImGui::SmallButton(text);
    ImGui::PopID();
    session.marks.last(name);
    return pressed;
}

void edit_table(Session& session, std::size_t term, Sampled which) {
    const std::size_t rows = sample_count(session.state, term, which);
    if (rows == 0) return;
    const bool profile = which == Sampled::profile;
    const std::vector<Field> fields = fields_of(session.state);
    const std::string name = session.state.scene.atmosphere.terms[term].name;
    const std::string begin = "term." + name + (profile ? ".profile." : ".phase.");
    // A group's fields stand together, row after row.
    auto field = std::ranges::find(fields, sample_group(name, which), &Field::group);
    ImGui::TextWrapped(profile ? "altitude (m), density; + adds a row behind, x takes it out"
                               : "angle from forward (rad), value of any scale; + adds a row behind, x takes it out");
    const auto edit_next = [&](const char* column, const std::string& number) {
        const bool is_next = field != fields.end() && field->name == begin + column + number;
        if (is_next) edit_field(session, *field++);
        return is_next;
    };
    ImGui::PushItemWidth(130);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::string number = std::to_string(row + 1);
        if (!edit_next(profile ? "altitude_m." : "angle_rad.", number))
            ImGui::Dummy({130, ImGui::GetFrameHeight()});  // the ends of a phase function
        ImGui::SameLine();
        edit_next(profile ? "density." : "value.", number);
        const bool inserts = button(session, "+", std::string(begin).append("insert.").append(number));
        const bool removes = button(session, "x", std::string(begin).append("remove.").append(number));
        if (inserts) attempt(session, [&] { insert_sample(session.state, term, which, row); });
        if (removes) attempt(session, [&] { remove_sample(session.state, term, which, row); });
        if (inserts || removes) break;  // the fields are of the rows before
    }
    ImGui::PopItemWidth();
}

}  // namespace

void edit_samples(Session& session, std::size_t term) {
    edit_table(session, term, Sampled::profile);
    edit_table(session, term, Sampled::phase);
}

}  // namespace aureole::viewer
