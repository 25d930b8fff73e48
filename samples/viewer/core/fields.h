// Everything of a state that can be edited, by name: what panels show as widgets and scripts set. A field is a number with a
// range and a unit in its label, or a text that is one of several.
#pragma once

#include "viewer/core/state.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace aureole::viewer {

struct Field {
    std::string group;  ///< "camera", "sun 1", "planet", "term mie", "pane a", "view" ...
    std::string name;   ///< "camera.bearing_deg", "sun.1.elevation_deg", "term.mie.profile.scale_height_m", "a.model" ...
    std::string label;  ///< "bearing (deg)"

    // A number, within its range (what sliders offer), by powers of ten where it spans many.
    std::function<double(const State&)> number{};
    std::function<void(State&, double)> set_number{};
    double least = 0, most = 0;
    bool logarithmic = false;

    // Or a text: one of these, or any where there are none. "false" and "true" make a check box.
    std::function<std::string(const State&)> text{};
    std::function<void(State&, const std::string&)> set_text{};
    std::vector<std::string> options{};

    [[nodiscard]] bool is_number() const { return static_cast<bool>(number); }
    [[nodiscard]] bool is_flag() const { return options.size() == 2 && options[1] == "true"; }
};

/// Those that this state has, in the order of their groups. Tables of the air may have thousands of rows: who shows none of
/// them leaves them out.
enum class Rows { left_out, all };
[[nodiscard]] std::vector<Field> fields_of(const State& state, Rows rows = Rows::all);

/// As text: numbers in full. Error(invalid_argument) for a name that there is not, as all below.
[[nodiscard]] std::string get_field(const State& state, const std::string& name);
/// Throws Error(invalid_argument) naming field, value and what is allowed, and changes nothing then; also where the air as a
/// whole would not be allowed.
void set_field(State& state, const std::string& name, const std::string& value);
/// The same of a field that is at hand.
void set_number(State& state, const Field& field, double value);
void set_text(State& state, const Field& field, const std::string& value);

/// The two tables that a term of the air may have: density over altitude, and a phase function over the angle. Each of their
/// rows has fields (term.mie.profile.altitude_m.1, .density.1; term.mie.phase.angle_rad.2, .value.1), row after row, in a group
/// of their own.
enum class Sampled { profile, phase };
[[nodiscard]] inline std::string sample_group(const std::string& term, Sampled which) {
    return "term " + term + (which == Sampled::profile ? ", profile's samples" : ", phase function's samples");
}
/// Rows of a term's table; 0 where it has none.
[[nodiscard]] std::size_t sample_count(const State& state, std::size_t term, Sampled which);
/// Behind a row (from 0), half-way to the next; behind a profile's last, as far above it as that is above the one before.
void insert_sample(State& state, std::size_t term, Sampled which, std::size_t row);
/// Throws Error(invalid_argument), and changes nothing, where the air's rules need the row: two must stay, and a phase
/// function's ends.
void remove_sample(State& state, std::size_t term, Sampled which, std::size_t row);

}  // namespace aureole::viewer
