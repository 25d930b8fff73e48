#include "scene/scene_atmosphere.h"

#include "io/csv.h"

#include <aureole/presets.h>

#include <algorithm>
#include <map>
#include <numbers>

namespace aureole::app {
namespace {

// Types are checked here; ranges by aureole::validate alone, whose messages are then led back to the lines of the file.
constexpr double inf = 1.7976931348623157e308;
constexpr Range any{-inf, inf};

/// Where a field of AtmosphereParameters was read: "terms[1].profile" -> its section.
using Origins = std::map<std::string, Section>;

Profile read_profile(Section section) {
    const auto kind = section.choice("kind", {"exponential", "tent", "tabulated"});
    if (!kind) section.reject("kind", "nothing", "\"exponential\", \"tent\", \"tabulated\"");
    Profile profile;
    if (*kind == 0) {
        ExponentialProfile p;
        p.scale_height_m = section.number("scale_height_m", any).value_or(p.scale_height_m);
        profile = p;
    } else if (*kind == 1) {
        TentProfile p;
        p.center_m = section.number("center_m", any).value_or(p.center_m);
        p.half_width_m = section.number("half_width_m", any).value_or(p.half_width_m);
        profile = p;
    } else {
        TabulatedProfile p;
        p.altitude_m = section.numbers("altitude_m", any).value_or(std::vector<double>{});
        p.density = section.numbers("density", any).value_or(std::vector<double>{});
        profile = p;
    }
    section.finish();
    return profile;
}

PhaseFunction read_draine(Section& section) {
    if (const auto diameter = section.number("droplet_diameter_um", {5, 50}))
        return HenyeyGreensteinDrainePhase::from_droplet_diameter(*diameter);
    HenyeyGreensteinDrainePhase p;
    p.g_hg = section.number("g_hg", any).value_or(p.g_hg);
    p.g_draine = section.number("g_draine", any).value_or(p.g_draine);
    p.alpha = section.number("alpha", any).value_or(p.alpha);
    p.weight = section.number("weight", any).value_or(p.weight);
    return p;
}

/// Angles as the file has them: what aureole::validate would say of them it would say in radians, and of another field.
void check_angles(const Section& section, const std::vector<double>& degrees) {
    const auto reject = [&](std::size_t i, const std::string& allowed) {
        section.reject("angle_deg", print_number(degrees[i]) + " as element " + std::to_string(i), allowed);
    };
    if (degrees.size() < 2 || degrees.size() > 4096)
        section.reject("angle_deg", std::to_string(degrees.size()) + " angles", "2 to 4096 of them, increasing from 0 to 180");
    if (degrees.front() != 0) reject(0, "0, the first angle");
    for (std::size_t i = 1; i < degrees.size(); ++i)
        if (!(degrees[i] > degrees[i - 1])) reject(i, "greater than " + print_number(degrees[i - 1]));
    if (degrees.back() != 180) reject(degrees.size() - 1, "180, the last angle");
}

PhaseFunction read_phase(Section section) {
    const auto kind =
        section.choice("kind", {"rayleigh", "henyey_greenstein", "cornette_shanks", "henyey_greenstein_draine", "tabulated"});
    PhaseFunction phase;
    switch (kind.value_or(5)) {
        case 0:
            phase = RayleighPhase{};
            break;
        case 1: {
            HenyeyGreensteinPhase p;
            p.g = section.number("g", any).value_or(p.g);
            phase = p;
            break;
        }
        case 2: {
            CornetteShanksPhase p;
            p.g = section.number("g", any).value_or(p.g);
            phase = p;
            break;
        }
        case 3:
            phase = read_draine(section);
            break;
        case 4: {
            TabulatedPhase p;
            p.angle_rad = section.numbers("angle_deg", any).value_or(std::vector<double>{});
            p.value = section.numbers("value", any).value_or(std::vector<double>{});
            section.finish();
            check_angles(section, p.angle_rad);
            for (double& angle : p.angle_rad) angle *= std::numbers::pi / 180;
            phase = p;
            break;
        }
        default:
            section.reject(
                "kind", "nothing",
                "\"rayleigh\", \"henyey_greenstein\", \"cornette_shanks\", \"henyey_greenstein_draine\", \"tabulated\"");
    }
    section.finish();
    return phase;
}

/// Changes the term of that name, or adds one.
void read_term(Section section, AtmosphereParameters& air, Origins& origins) {
    const std::optional<std::string> name = section.text("name");
    if (!name) section.reject("name", "nothing", "the name of a term, e.g. \"mie\"");
    auto term = std::ranges::find(air.terms, *name, &DensityTerm::name);
    if (term == air.terms.end()) {
        air.terms.emplace_back();
        term = std::prev(air.terms.end());
        term->name = *name;
    }
    const std::string field = "terms[" + std::to_string(term - air.terms.begin()) + "]";
    origins.insert_or_assign(field, section);
    term->scattering_per_m = section.rgb("scattering_per_m", any).value_or(term->scattering_per_m);
    term->absorption_per_m = section.rgb("absorption_per_m", any).value_or(term->absorption_per_m);
    term->scattering_scale = section.number("scattering_scale", any).value_or(term->scattering_scale);
    term->absorption_scale = section.number("absorption_scale", any).value_or(term->absorption_scale);
    if (const auto profile = section.section("profile")) {
        origins.insert_or_assign(field + ".profile", *profile);
        term->profile = read_profile(*profile);
    }
    if (const auto phase = section.section("phase")) {
        origins.insert_or_assign(field + ".phase", *phase);
        term->phase = read_phase(*phase);
    }
    section.finish();
}

/// `field` as aureole::validate names it, e.g. "terms[1].profile.altitude_m[3]", at its place in the file.
[[noreturn]] void reject_at_origin(const Error& error, const Section& whole, const Origins& origins) {
    const Section* origin = &whole;
    std::string rest = error.field();
    if (rest.starts_with("planet.")) rest.erase(0, 7);
    std::size_t longest = 0;
    for (const auto& [prefix, section] : origins) {
        if (prefix.size() > longest && error.field().starts_with(prefix + ".")) {
            longest = prefix.size();
            origin = &section;
            rest = error.field().substr(prefix.size() + 1);
        }
    }
    // The key is the part before what stands inside it: "altitude_m" of "altitude_m[3]", "ground_albedo" of "ground_albedo.g".
    const std::string key = rest.substr(0, rest.find_first_of(".["));
    if (origin->has(key)) origin->reject(key, error.value() + " (" + rest + ")", error.allowed());
    origin->reject("", error.value() + " (" + rest + ")", error.allowed());
}

}  // namespace

AtmosphereParameters read_atmosphere(Section section) {
    AtmosphereParameters air;
    std::vector<std::string_view> choices(presets::names().begin(), presets::names().end());
    choices.emplace_back("none");  // a planet of the size of Earth without air, to which everything is added
    const std::size_t preset = section.choice("preset", choices).value_or(0);
    if (preset + 1 < choices.size()) air = presets::by_name(choices[preset]);
    Planet& planet = air.planet;
    planet.bottom_radius_m = section.number("bottom_radius_m", any).value_or(planet.bottom_radius_m);
    planet.top_radius_m = section.number("top_radius_m", any).value_or(planet.top_radius_m);
    planet.ground_albedo = section.rgb("ground_albedo", any).value_or(planet.ground_albedo);
    Origins origins;
    for (const Section& term : section.sections("term")) read_term(term, air, origins);
    section.finish();
    try {
        validate(air);
    } catch (const Error& error) {
        reject_at_origin(error, section, origins);
    }
    return air;
}

}  // namespace aureole::app
