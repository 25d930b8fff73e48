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
    ImGui::TextWrapped(profile ? "altitude (m), density; + adds a row behind, x takes it out"
                               : "angle from forward (rad), value of any scale; + adds a row behind, x takes it out");
    const auto field_at = [&](const char* column, std::size_t row) {
        return std::ranges::find(fields, begin + column + "." + std::to_string(row + 1), &Field::name);
    };
    ImGui::PushItemWidth(130);
    for (std::size_t row = 0; row < std::min(rows, most_sample_rows); ++row) {
        const std::string number = std::to_string(row + 1);
        if (const auto x = field_at(profile ? "altitude_m" : "angle_rad", row); x != fields.end())
            edit_field(session, *x);
        else
            ImGui::Dummy({130, ImGui::GetFrameHeight()});  // the ends of a phase function
        ImGui::SameLine();
        if (const auto y = field_at(profile ? "density" : "value", row); y != fields.end()) edit_field(session, *y);
        const bool inserts = button(session, "+", begin + "insert." + number);
        const bool removes = button(session, "x", begin + "remove." + number);
        if (inserts) attempt(session, [&] { insert_sample(session.state, term, which, row); });
        if (removes) attempt(session, [&] { remove_sample(session.state, term, which, row); });
        if (inserts || removes) break;  // the fields are of the rows before
    }
    ImGui::PopItemWidth();
    if (rows > most_sample_rows) ImGui::Text("%zu more rows: the scene file has them all", rows - most_sample_rows);
}

}  // namespace

void edit_samples(Session& session, std::size_t term) {
    edit_table(session, term, Sampled::profile);
    edit_table(session, term, Sampled::phase);
}

}  // namespace aureole::viewer
