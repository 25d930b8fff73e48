#include "viewer/core/field_builder.h"

#include <algorithm>
#include <optional>

namespace aureole::viewer {
namespace {

/// Abscissas and ordinates of a term's table, const or not; none where the term has no such table.
template <class Term>
auto pairs_of(Term& term, Sampled which) {
    using Numbers = std::conditional_t<std::is_const_v<Term>, const std::vector<double>, std::vector<double>>;
    struct Pairs {
        Numbers* x = nullptr;
        Numbers* y = nullptr;
    };
    if (which == Sampled::profile)
        if (auto* profile = std::get_if<TabulatedProfile>(&term.profile)) return Pairs{&profile->altitude_m, &profile->density};
    if (which == Sampled::phase)
        if (auto* phase = std::get_if<TabulatedPhase>(&term.phase)) return Pairs{&phase->angle_rad, &phase->value};
    return Pairs{};
}

/// Between its neighbours, where it has them. They may not meet: that is refused as all that the air's own rules refuse.
Reach reach_of(const std::vector<double>& x, std::size_t row) {
    const double least = std::min(-1e3, x[row]), most = std::max({1e5, x[row], 2 * x[row]});
    return {row > 0 ? x[row - 1] : least, row + 1 < x.size() ? x[row + 1] : most};
}

template <class Change>
void change_samples(State& state, std::size_t term, Sampled which, Change change) {
    State changed = state;
    const auto pairs = pairs_of(changed.scene.atmosphere.terms.at(term), which);
    if (!pairs.x) return;
    change(*pairs.x, *pairs.y);
    validate(changed.scene.atmosphere);
    state = std::move(changed);
}

}  // namespace

std::size_t sample_count(const State& state, std::size_t term, Sampled which) {
    const auto pairs = pairs_of(state.scene.atmosphere.terms.at(term), which);
    return pairs.x ? pairs.x->size() : 0;
}

void insert_sample(State& state, std::size_t term, Sampled which, std::size_t row) {
    change_samples(state, term, which, [&](std::vector<double>& x, std::vector<double>& y) {
        const std::size_t last = x.size() - 1;
        if (row >= last && which == Sampled::profile) {  // upwards there is room
            x.push_back(2 * x[last] - x[last - 1]);
            y.push_back(y[last]);
            return;
        }
        const std::size_t from = std::min(row, last - 1);
        const auto at = static_cast<std::ptrdiff_t>(from + 1);
        const double middle = (x[from] + x[from + 1]) / 2, value = (y[from] + y[from + 1]) / 2;
        x.insert(x.begin() + at, middle);
        y.insert(y.begin() + at, value);
    });
}

void remove_sample(State& state, std::size_t term, Sampled which, std::size_t row) {
    change_samples(state, term, which, [&](std::vector<double>& x, std::vector<double>& y) {
        if (row >= x.size()) return;
        x.erase(x.begin() + static_cast<std::ptrdiff_t>(row));
        y.erase(y.begin() + static_cast<std::ptrdiff_t>(row));
    });
}

void add_sample_fields(FieldBuilder& add, const DensityTerm& term, std::size_t i) {
    for (const Sampled which : {Sampled::profile, Sampled::phase}) {
        const auto pairs = pairs_of(term, which);
        if (!pairs.x) continue;
        const bool profile = which == Sampled::profile;
        const std::string x_name = profile ? "altitude_m." : "angle_rad.", y_name = profile ? "density." : "value.";
        add.group(sample_group(term.name, which), "term." + term.name + (profile ? ".profile." : ".phase."));
        const double most = std::max(10.0, 10 * *std::ranges::max_element(*pairs.y));
        for (std::size_t row = 0; row < pairs.x->size(); ++row) {
            const std::string number = std::to_string(row + 1);
            const auto samples = [i, which](auto& s) { return pairs_of(s.scene.atmosphere.terms[i], which); };
            // A phase function goes from 0 to pi: its ends stay.
            if (profile || (row > 0 && row + 1 < pairs.x->size()))
                add.number(
                    x_name + number, "##x", reach_of(*pairs.x, row),
                    [ samples, row ](auto& s) -> auto& { return (*samples(s).x)[row]; });
            add.number(
                y_name + number, "##y", {0, std::min(most, profile ? 1e6 : 1e100), true},
                [ samples, row ](auto& s) -> auto& { return (*samples(s).y)[row]; });
        }
    }
}

}  // namespace aureole::viewer
