#include "viewer/core/field_builder.h"

#include <aureole/presets.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace aureole::viewer {
namespace {

constexpr Reach coefficient{0, 1, true};  // 1/m at density 1: more is a wall
constexpr Reach asymmetry{-0.999, 0.999};
const std::vector<std::string> profile_kinds{"exponential", "tent", "tabulated"};
const std::vector<std::string> phase_kinds{"rayleigh", "henyey_greenstein", "cornette_shanks", "henyey_greenstein_draine",
                                           "tabulated"};

DensityTerm& term_of(State& state, std::size_t i) { return state.scene.atmosphere.terms[i]; }
const DensityTerm& term_of(const State& state, std::size_t i) { return state.scene.atmosphere.terms[i]; }

void add_planet(FieldBuilder& add, const State& state) {
    add.group("planet", "planet.");
    std::vector<std::string> presets{"own"};
    for (const std::string_view name : presets::names()) presets.emplace_back(name);
    add.text(
        "preset", "preset", presets,
        [](const State& s) -> std::string {
            for (const std::string_view name : presets::names())
                if (presets::by_name(name) == s.scene.atmosphere) return std::string(name);
            return "own";
        },
        [](State& s, const std::string& name) {
            if (name != "own") s.scene.atmosphere = presets::by_name(name);
        });
    const Planet& planet = state.scene.atmosphere.planet;
    add.number(
        "bottom_radius_m", "radius of the ground (m)", {1e3, std::min(1e12, planet.top_radius_m - 1), true},
        [](auto& s) -> auto& { return s.scene.atmosphere.planet.bottom_radius_m; });
    add.number(
        "top_radius_m", "radius of the top of the air (m)", {planet.bottom_radius_m + 1, 11 * planet.bottom_radius_m, true},
        [](auto& s) -> auto& { return s.scene.atmosphere.planet.top_radius_m; });
    add.colour(
        "ground_albedo", "albedo of the ground", {0, 1},
        [](auto& s) -> auto& { return s.scene.atmosphere.planet.ground_albedo; });
}

/// What stands for a kind that has no numbers yet.
Profile profile_of(const std::string& kind) {
    if (kind == "tent") return TentProfile{};
    if (kind == "tabulated") return TabulatedProfile{{0, 1000, 10000}, {1, 1, 0}};
    return ExponentialProfile{};
}
PhaseFunction phase_of(const std::string& kind) {
    if (kind == "henyey_greenstein") return HenyeyGreensteinPhase{};
    if (kind == "cornette_shanks") return CornetteShanksPhase{};
    if (kind == "henyey_greenstein_draine") return HenyeyGreensteinDrainePhase{};
    if (kind == "tabulated") return TabulatedPhase{{0, std::numbers::pi}, {1, 1}};
    return RayleighPhase{};
}

void add_profile(FieldBuilder& add, const DensityTerm& term, std::size_t i) {
    add.text(
        "profile", "density over altitude", profile_kinds,
        [i](const State& s) { return profile_kinds[term_of(s, i).profile.index()]; },
        [i](State& s, const std::string& kind) {
            if (kind != profile_kinds[term_of(s, i).profile.index()]) term_of(s, i).profile = profile_of(kind);
        });
    if (std::holds_alternative<ExponentialProfile>(term.profile))
        add.number(
            "scale_height_m", "scale height (m)", {0.01, 1e6, true}, [i](auto& s) -> auto& {
                return std::get<ExponentialProfile>(term_of(s, i).profile).scale_height_m;
            });
    if (!std::holds_alternative<TentProfile>(term.profile)) return;
    add.number(
        "center_m", "middle of the layer (m)",
        {-1e6, 1e6}, [i](auto& s) -> auto& { return std::get<TentProfile>(term_of(s, i).profile).center_m; });
    add.number(
        "half_width_m", "half of the layer's thickness (m)",
        {0.01, 1e6, true}, [i](auto& s) -> auto& { return std::get<TentProfile>(term_of(s, i).profile).half_width_m; });
}

void add_phase(FieldBuilder& add, const DensityTerm& term, std::size_t i) {
    add.text(
        "phase", "phase function", phase_kinds, [i](const State& s) { return phase_kinds[term_of(s, i).phase.index()]; },
        [i](State& s, const std::string& kind) {
            if (kind != phase_kinds[term_of(s, i).phase.index()]) term_of(s, i).phase = phase_of(kind);
        });
    if (std::holds_alternative<HenyeyGreensteinPhase>(term.phase))
        add.number(
            "g", "mean cosine g",
            asymmetry, [i](auto& s) -> auto& { return std::get<HenyeyGreensteinPhase>(term_of(s, i).phase).g; });
    if (std::holds_alternative<CornetteShanksPhase>(term.phase))
        add.number(
            "g", "g", asymmetry, [i](auto& s) -> auto& { return std::get<CornetteShanksPhase>(term_of(s, i).phase).g; });
    if (!std::holds_alternative<HenyeyGreensteinDrainePhase>(term.phase)) return;
    const auto draine = [i](auto& s) -> auto& { return std::get<HenyeyGreensteinDrainePhase>(term_of(s, i).phase); };
    add.number(
        "g_hg", "g of the first lobe", asymmetry, [draine](auto& s) -> auto& { return draine(s).g_hg; });
    add.number(
        "g_draine", "g of Draine's lobe", asymmetry, [draine](auto& s) -> auto& { return draine(s).g_draine; });
    add.number(
        "alpha", "alpha of Draine's lobe", {0, 1e4, true}, [draine](auto& s) -> auto& { return draine(s).alpha; });
    add.number(
        "weight", "share of Draine's lobe", {0, 1}, [draine](auto& s) -> auto& { return draine(s).weight; });
}

}  // namespace

void add_air_fields(FieldBuilder& add, const State& state, Rows rows) {
    add_planet(add, state);
    for (std::size_t i = 0; i < state.scene.atmosphere.terms.size(); ++i) {
        const DensityTerm& term = term_of(state, i);
        add.group("term " + term.name, "term." + term.name + ".");
        add.colour(
            "scattering_per_m", "scattering (1/m)",
            coefficient, [i](auto& s) -> auto& { return term_of(s, i).scattering_per_m; });
        add.colour(
            "absorption_per_m", "absorption (1/m)",
            coefficient, [i](auto& s) -> auto& { return term_of(s, i).absorption_per_m; });
        add.number(
            "scattering_scale", "scattering times",
            {0, 1e3, true}, [i](auto& s) -> auto& { return term_of(s, i).scattering_scale; });
        add.number(
            "absorption_scale", "absorption times",
            {0, 1e3, true}, [i](auto& s) -> auto& { return term_of(s, i).absorption_scale; });
        add_profile(add, term, i);
        add_phase(add, term, i);
        if (rows == Rows::all) add_sample_fields(add, term, i);
    }
}

}  // namespace aureole::viewer
