// How fields.cpp and its sisters write fields down.
#pragma once

#include "viewer/core/fields.h"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace aureole::viewer {

struct Reach {
    double least, most;
    bool logarithmic = false;
};

class FieldBuilder {
public:
    explicit FieldBuilder(std::vector<Field>& fields) : fields_(fields) {}
    /// Of the fields that follow. `prefix` begins their names.
    void group(std::string name, std::string prefix) {
        group_ = std::move(name);
        prefix_ = std::move(prefix);
    }

    /// `access` takes a State, const or not, to the number.
    template <class Access>
    Field& number(const std::string& name, const std::string& label, Reach reach, Access access) {
        Field& field = add(name, label);
        field.number = [access](const State& state) { return static_cast<double>(access(state)); };
        field.set_number = [access](State& state, double value) {
            access(state) = static_cast<std::remove_cvref_t<decltype(access(state))>>(value);
        };
        field.least = reach.least;
        field.most = reach.most;
        field.logarithmic = reach.logarithmic;
        return field;
    }
    /// Red, green and blue.
    template <class Access>
    void colour(const std::string& name, const std::string& label, Reach reach, Access access) {
        static constexpr const char* channels[3] = {"r", "g", "b"};
        for (int c = 0; c < 3; ++c)
            number(
                name + "." + channels[c], label + " " + channels[c], reach,
                [ access, c ](auto& state) -> auto& { return access(state)[c]; });
    }
    template <class Access>
    Field& flag(const std::string& name, const std::string& label, Access access) {
        return text(
            name, label, {"false", "true"},
            [access](const State& state) -> std::string { return access(state) ? "true" : "false"; },
            [access](State& state, const std::string& value) { access(state) = value == "true"; });
    }
    Field& text(const std::string& name, const std::string& label, std::vector<std::string> options,
                std::function<std::string(const State&)> get, std::function<void(State&, const std::string&)> set) {
        Field& field = add(name, label);
        field.options = std::move(options);
        field.text = std::move(get);
        field.set_text = std::move(set);
        return field;
    }

private:
    Field& add(const std::string& name, const std::string& label) {
        Field& field = fields_.emplace_back();
        field.group = group_;
        field.name = prefix_ + name;
        field.label = label;
        return field;
    }
    std::vector<Field>& fields_;
    std::string group_, prefix_;
};

void add_scene_fields(FieldBuilder& add, const State& state);
void add_air_fields(FieldBuilder& add, const State& state, Rows rows);
void add_sample_fields(FieldBuilder& add, const DensityTerm& term, std::size_t i);
void add_pane_fields(FieldBuilder& add);

}  // namespace aureole::viewer
