#include "viewer/core/fields.h"

#include "io/csv.h"
#include "viewer/core/field_builder.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace aureole::viewer {
namespace {

std::vector<std::string> strings(std::span<const std::string_view> names) { return {names.begin(), names.end()}; }

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string listed(const std::vector<std::string>& options) {
    std::string text;
    for (const std::string& option : options) text.append(text.empty() ? "" : ", ").append(option);
    return text;
}

std::vector<std::string> spectral_options() {
    std::vector<std::string> options{"rgb"};
    for (int i = 3; i <= 42; ++i) options.push_back(std::to_string(i));
    return options;
}

Field field_named(const State& state, const std::string& name) {
    std::vector<Field> fields = fields_of(state);
    const auto found = std::ranges::find(fields, name, &Field::name);
    if (found != fields.end()) return *found;
    std::string known;
    for (const Field& field : fields) known.append(known.empty() ? "" : ", ").append(field.name);
    throw Error(ErrorCode::invalid_argument, "field", quoted(name), known);
}

double parse_number(const Field& field, const std::string& text) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size())
        throw Error(ErrorCode::invalid_argument, field.name, quoted(text), "a number");
    return value;
}

void add_view_fields(FieldBuilder& add) {
    add.group("view", "view.");
    add.text(
        "layout", "layout", strings(layout_names()),
        [](const State& s) { return std::string(layout_names()[static_cast<std::size_t>(s.layout)]); },
        [](State& s, const std::string& name) {
            s.layout = static_cast<Layout>(std::ranges::find(layout_names(), name) - layout_names().begin());
        });
    add.number(
        "divider", "divider (share of the width)", {0, 1}, [](auto& s) -> auto& { return s.divider; });
    add.number(
        "difference_range", "full colour at (relative)", {1e-6, 10, true}, [](auto& s) -> auto& { return s.difference_range; });
    add.number(
        "resolution", "resolution (of the window's)", {0.05, 1}, [](auto& s) -> auto& { return s.resolution; });
    add.flag(
        "labels", "labels over the picture", [](auto& s) -> auto& { return s.labels; });
    add.flag(
        "curves", "curves", [](auto& s) -> auto& { return s.curves; });
    add.flag(
        "table", "table", [](auto& s) -> auto& { return s.table; });
    add.number(
        "table_pane", "of pane (0: a, 1: b)", {0, 1}, [](auto& s) -> auto& { return s.table_pane; });
    add.text(
        "table_name", "table", {}, [](const State& s) { return s.table_name; },
        [](State& s, const std::string& name) { s.table_name = name; });
    add.number(
        "table_slice", "slice", {0, 4095}, [](auto& s) -> auto& { return s.table_slice; });
}

}  // namespace

void add_pane_fields(FieldBuilder& add) {
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string letter = i == 0 ? "a" : "b";
        add.group("pane " + letter, letter + ".");
        const auto text = [&](const char* name, const std::vector<std::string>& options, auto access) {
            add.text(
                name, name, options, [access](const State& s) -> std::string { return access(s); },
                [access](State& s, const std::string& value) { access(s) = value; });
        };
        text(
            "backend", {"vulkan", "cpu", "cpu-double"}, [i](auto& s) -> auto& { return s.panes[i].backend; });
        add.flag(
            "planned", "let the planner choose", [i](auto& s) -> auto& { return s.panes[i].planned; });
        add.number(
            "tolerance", "tolerance (relative error)",
            {1e-4, 10, true}, [i](auto& s) -> auto& { return s.panes[i].tolerance; });
        text(
            "model", strings(model_names()), [i](auto& s) -> auto& { return s.panes[i].model.name; });
        text(
            "quality", strings(quality_names()), [i](auto& s) -> auto& { return s.panes[i].model.quality; });
        text(
            "spectral", spectral_options(), [i](auto& s) -> auto& { return s.panes[i].model.spectral; });
    }
}

std::vector<Field> fields_of(const State& state, Rows rows) {
    std::vector<Field> fields;
    FieldBuilder add(fields);
    add_scene_fields(add, state);
    add_air_fields(add, state, rows);
    add_pane_fields(add);
    add_view_fields(add);
    return fields;
}

std::string get_field(const State& state, const std::string& name) {
    const Field field = field_named(state, name);
    return field.is_number() ? app::print_number(field.number(state)) : field.text(state);
}

void set_field(State& state, const std::string& name, const std::string& value) {
    State changed = state;
    // A clearance above the land gives way to an altitude.
    if (name == "camera.altitude_m") changed.scene.camera.clearance_m.reset();
    const Field field = field_named(changed, name);
    if (field.is_number())
        set_number(changed, field, parse_number(field, value));
    else
        set_text(changed, field, value);
    state = std::move(changed);
}

void set_number(State& state, const Field& field, double value) {
    if (!(value >= field.least && value <= field.most))
        throw Error(ErrorCode::invalid_argument, field.name, app::print_number(value),
                    "in [" + app::print_number(field.least) + ", " + app::print_number(field.most) + "]");
    State changed = state;
    field.set_number(changed, value);
    validate(changed.scene.atmosphere);
    state = std::move(changed);
}

void set_text(State& state, const Field& field, const std::string& value) {
    if (!field.options.empty() && std::ranges::find(field.options, value) == field.options.end())
        throw Error(ErrorCode::invalid_argument, field.name, quoted(value), listed(field.options));
    State changed = state;
    field.set_text(changed, value);
    validate(changed.scene.atmosphere);
    state = std::move(changed);
}

}  // namespace aureole::viewer
