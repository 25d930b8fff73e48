#include <algorithm>
#include <type_traits>
#include <utility>

#include "convert.h"

namespace aureole::c_api {
namespace {

std::vector<double> samples(const double* from, std::uint32_t count, const std::string& name) {
    given(from, name);
    return {from, from + count};
}

Profile to_cpp(const aureole_profile& profile, const std::string& name) {
    switch (profile.kind) {
        case AUREOLE_PROFILE_EXPONENTIAL:
            return ExponentialProfile{profile.scale_height_m};
        case AUREOLE_PROFILE_TENT:
            return TentProfile{profile.center_m, profile.half_width_m};
        case AUREOLE_PROFILE_TABULATED:
            return TabulatedProfile{samples(profile.altitude_m, profile.count, name + ".altitude_m"),
                                    samples(profile.density, profile.count, name + ".density")};
    }
    throw Error(ErrorCode::invalid_argument, name + ".kind", std::to_string(profile.kind), "0 to 2");
}

PhaseFunction to_cpp(const aureole_phase& phase, const std::string& name) {
    switch (phase.kind) {
        case AUREOLE_PHASE_RAYLEIGH:
            return RayleighPhase{};
        case AUREOLE_PHASE_HENYEY_GREENSTEIN:
            return HenyeyGreensteinPhase{phase.g};
        case AUREOLE_PHASE_CORNETTE_SHANKS:
            return CornetteShanksPhase{phase.g};
        case AUREOLE_PHASE_HENYEY_GREENSTEIN_DRAINE:
            return HenyeyGreensteinDrainePhase{phase.g_hg, phase.g_draine, phase.alpha, phase.weight};
        case AUREOLE_PHASE_TABULATED:
            return TabulatedPhase{samples(phase.angle_rad, phase.count, name + ".angle_rad"),
                                  samples(phase.value, phase.count, name + ".value")};
    }
    throw Error(ErrorCode::invalid_argument, name + ".kind", std::to_string(phase.kind), "0 to 4");
}

DensityTerm to_cpp(const aureole_term& term, const std::string& name) {
    return {text(term.name),
            to_cpp(term.profile, name + ".profile"),
            rgb(term.scattering_per_m),
            rgb(term.absorption_per_m),
            to_cpp(term.phase, name + ".phase"),
            term.scattering_scale,
            term.absorption_scale};
}

/// Every kind's fields, so that a caller who changes the kind alone gets that kind's defaults.
aureole_profile to_c(const Profile& profile) {
    const ExponentialProfile exponential;
    const TentProfile tent;
    aureole_profile c{
        number(profile.index()), 0, exponential.scale_height_m, tent.center_m, tent.half_width_m, nullptr, nullptr};
    if (const auto* e = std::get_if<ExponentialProfile>(&profile)) c.scale_height_m = e->scale_height_m;
    if (const auto* t = std::get_if<TentProfile>(&profile)) c.center_m = t->center_m, c.half_width_m = t->half_width_m;
    if (const auto* t = std::get_if<TabulatedProfile>(&profile)) {
        c.count = static_cast<std::uint32_t>(t->altitude_m.size());
        c.altitude_m = t->altitude_m.data(), c.density = t->density.data();
    }
    return c;
}

aureole_phase to_c(const PhaseFunction& phase) {
    const HenyeyGreensteinDrainePhase draine;
    aureole_phase c{number(phase.index()),
                    0,
                    HenyeyGreensteinPhase{}.g,
                    draine.g_hg,
                    draine.g_draine,
                    draine.alpha,
                    draine.weight,
                    nullptr,
                    nullptr};
    if (const auto* p = std::get_if<HenyeyGreensteinPhase>(&phase)) c.g = p->g;
    if (const auto* p = std::get_if<CornetteShanksPhase>(&phase)) c.g = p->g;
    if (const auto* p = std::get_if<HenyeyGreensteinDrainePhase>(&phase))
        c.g_hg = p->g_hg, c.g_draine = p->g_draine, c.alpha = p->alpha, c.weight = p->weight;
    if (const auto* p = std::get_if<TabulatedPhase>(&phase)) {
        c.count = static_cast<std::uint32_t>(p->angle_rad.size());
        c.angle_rad = p->angle_rad.data(), c.value = p->value.data();
    }
    return c;
}

// The kinds in C are the places of the alternatives in C++.
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_PROFILE_TENT, Profile>, TentProfile>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_PROFILE_TABULATED, Profile>, TabulatedProfile>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_PHASE_CORNETTE_SHANKS, PhaseFunction>, CornetteShanksPhase>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_PHASE_HENYEY_GREENSTEIN_DRAINE, PhaseFunction>,
                             HenyeyGreensteinDrainePhase>);
static_assert(std::is_same_v<std::variant_alternative_t<AUREOLE_PHASE_TABULATED, PhaseFunction>, TabulatedPhase>);

aureole_term to_c(const DensityTerm& term) {
    aureole_term c{};
    c.struct_size = sizeof c;
    c.name = term.name.c_str();
    c.profile = to_c(term.profile);
    copy(term.scattering_per_m, c.scattering_per_m);
    copy(term.absorption_per_m, c.absorption_per_m);
    c.phase = to_c(term.phase);
    c.scattering_scale = term.scattering_scale;
    c.absorption_scale = term.absorption_scale;
    return c;
}

}  // namespace

Rgb rgb(const double from[3]) { return {from[0], from[1], from[2]}; }
void copy(const Rgb& from, double to[3]) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

aureole_term default_term() {
    static const DensityTerm term;
    aureole_term c = to_c(term);
    c.name = nullptr;
    return c;
}

AirInC::AirInC(AtmosphereParameters air) : air_(std::move(air)) {
    for (const DensityTerm& term : air_.terms) terms_.push_back(to_c(term));
    parameters_.struct_size = sizeof parameters_;
    parameters_.term_count = static_cast<std::uint32_t>(terms_.size());
    parameters_.bottom_radius_m = air_.planet.bottom_radius_m;
    parameters_.top_radius_m = air_.planet.top_radius_m;
    copy(air_.planet.ground_albedo, parameters_.ground_albedo);
    parameters_.terms = terms_.empty() ? nullptr : terms_.data();
}

AtmosphereParameters read_parameters(const aureole_parameters* parameters, std::string_view name) {
    static const AirInC defaults{AtmosphereParameters{}};
    const aureole_parameters c = read(parameters, name, defaults.parameters());
    AtmosphereParameters air;
    air.planet = {c.bottom_radius_m, c.top_radius_m, rgb(c.ground_albedo)};
    const aureole_term usual = default_term();
    for (std::uint32_t i = 0; i < c.term_count; ++i) {
        const std::string field = "terms[" + std::to_string(i) + "]";
        given(c.terms, "terms");
        check_size<aureole_term>(c.terms->struct_size, "terms[0]");
        aureole_term term = usual;
        std::memcpy(&term, element(c.terms, i), c.terms->struct_size);
        air.terms.push_back(to_cpp(term, field));
    }
    return air;
}

void write_outside(std::vector<OutsideEnvelope> outside, aureole_outside* out, std::uint32_t capacity,
                   std::uint32_t* out_count) {
    struct Kept {
        std::vector<OutsideEnvelope> numbers;
        std::vector<std::string> texts;
    };
    thread_local Kept kept;
    Kept fresh{std::move(outside), {}};
    for (const OutsideEnvelope& number : fresh.numbers) fresh.texts.push_back(number.text());
    kept = std::move(fresh);
    write_all<aureole_outside>(out, capacity, out_count, "out", kept.numbers.size(), [](std::size_t i) {
        const OutsideEnvelope& number = kept.numbers[i];
        return aureole_outside{sizeof(aureole_outside), number.field.c_str(), number.value, number.least,
                               number.greatest,         kept.texts[i].c_str()};
    });
}

}  // namespace aureole::c_api

using namespace aureole;
using namespace aureole::c_api;

aureole_result aureole_term_defaults(aureole_term* term) {
    return guarded([&] { write(term, "term", default_term()); });
}

aureole_result aureole_parameters_defaults(aureole_parameters* parameters) {
    return guarded([&] { write(parameters, "parameters", AirInC(AtmosphereParameters{}).parameters()); });
}
