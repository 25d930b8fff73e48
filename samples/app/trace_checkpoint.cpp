#include "app/trace_checkpoint.h"

#include "io/csv.h"
#include "io/file.h"
#include "io/json_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace aureole::app {
namespace {

using nlohmann::json;

constexpr const char* format = "aureole trace checkpoint 1";

std::string print(const Rgb& v) { return print_number(v.r) + "," + print_number(v.g) + "," + print_number(v.b); }
/// Without what the change of units adds in the last place.
std::string rounded(double value) { return print_number(value, 15); }
std::string per_km(const Rgb& v) { return rounded(1000 * v.r) + "," + rounded(1000 * v.g) + "," + rounded(1000 * v.b); }
std::string print(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text.append(text.empty() ? "" : ",").append(print_number(value));
    return text;
}

struct Printer {
    std::string operator()(const ExponentialProfile& p) const {
        return "exponential:scale_height_km:" + rounded(p.scale_height_m / 1000);
    }
    std::string operator()(const TentProfile& p) const {
        return "tent:center_km:" + rounded(p.center_m / 1000) + ":half_width_km:" + rounded(p.half_width_m / 1000);
    }
    std::string operator()(const TabulatedProfile& p) const {
        return "tabulated:altitude_m:" + print(p.altitude_m) + ":density:" + print(p.density);
    }
    std::string operator()(const RayleighPhase&) const { return "rayleigh"; }
    std::string operator()(const HenyeyGreensteinPhase& p) const { return "henyey_greenstein:g:" + print_number(p.g); }
    std::string operator()(const CornetteShanksPhase& p) const { return "cornette_shanks:g:" + print_number(p.g); }
    std::string operator()(const HenyeyGreensteinDrainePhase& p) const {
        return "henyey_greenstein_draine:g_hg:" + print_number(p.g_hg) + ":g_draine:" + print_number(p.g_draine) +
               ":alpha:" + print_number(p.alpha) + ":weight:" + print_number(p.weight);
    }
    std::string operator()(const TabulatedPhase& p) const {
        return "tabulated:angle_rad:" + print(p.angle_rad) + ":value:" + print(p.value);
    }
};

json pack(const Rgb& v) { return {v.r, v.g, v.b}; }
Rgb unpack(const json& v) { return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()}; }

json pack(const ProbeRow& row) { return {row.sun_zenith_deg, row.altitude_km, row.view_zenith_deg, row.azimuth_deg}; }

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what, const std::string& there,
                         const std::string& here) {
    throw Error(ErrorCode::invalid_argument, path.string() + " is the checkpoint of another trace: " + what + " is " + there +
                                                 " there and " + here + " here");
}

void compare(const std::filesystem::path& path, const json& there, const TraceParameters& here) {
    for (std::size_t i = 0; i < std::max(there.size(), here.size()); ++i) {
        const std::string name = i < there.size() ? there[i].at(0).get<std::string>() : here[i].first;
        const std::string value = i < there.size() ? there[i].at(1).get<std::string>() : "absent";
        const auto same = std::ranges::find(here, name, &TraceParameters::value_type::first);
        if (same == here.end()) refuse(path, name, value, "absent");
        if (same->second != value) refuse(path, name, value, same->second);
        if (i < here.size() && here[i].first != name) refuse(path, here[i].first, "absent or elsewhere", here[i].second);
    }
}

void compare(const std::filesystem::path& path, const json& there, const std::vector<ProbeRow>& here) {
    if (there.size() != here.size())
        refuse(path, "the number of directions", std::to_string(there.size()), std::to_string(here.size()));
    for (std::size_t i = 0; i < here.size(); ++i)
        if (there[i] != pack(here[i]))
            refuse(path, "direction " + std::to_string(i + 1) + " [sun_zenith_deg, altitude_km, view_zenith_deg, azimuth_deg]",
                   show_json(there[i]), show_json(pack(here[i])));
}

}  // namespace

TraceParameters describe(const AtmosphereParameters& parameters) {
    TraceParameters values{{"bottom_radius_km", rounded(parameters.planet.bottom_radius_m / 1000)},
                           {"top_radius_km", rounded(parameters.planet.top_radius_m / 1000)},
                           {"ground_albedo", print(parameters.planet.ground_albedo)}};
    for (std::size_t i = 0; i < parameters.terms.size(); ++i) {
        const DensityTerm& term = parameters.terms[i];
        const std::string prefix = "term" + std::to_string(i + 1) + "_";
        values.emplace_back(prefix + "name", term.name);
        values.emplace_back(prefix + "scattering_per_km", per_km(term.scattering_per_m * term.scattering_scale));
        values.emplace_back(prefix + "absorption_per_km", per_km(term.absorption_per_m * term.absorption_scale));
        values.emplace_back(prefix + "profile", std::visit(Printer{}, term.profile));
        values.emplace_back(prefix + "phase", std::visit(Printer{}, term.phase));
    }
    return values;
}

std::string print_parameters(const TraceParameters& parameters) {
    std::string text;
    for (const auto& [name, value] : parameters) text.append(text.empty() ? "" : " ").append(name).append("=").append(value);
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

void write_checkpoint(const std::filesystem::path& path, const TraceParameters& parameters, const Tracer& tracer) {
    json file{{"format", format}, {"parameters", json::array()}, {"directions", json::array()}, {"states", json::array()}};
    for (const auto& [name, value] : parameters) file["parameters"].push_back({name, value});
    for (const ProbeRow& row : tracer.rows()) file["directions"].push_back(pack(row));
    for (const TraceState& state : tracer.states()) {
        json tallies = json::array();
        for (const Tally& tally : state.tallies) tallies.push_back({pack(tally.mean), pack(tally.spread)});
        file["states"].push_back({state.rounds, tallies});
    }
    // Numbers as short as they can be and still read back as the same bits.
    write_text(path, file.dump() + "\n");
}

void read_checkpoint(const std::filesystem::path& path, const TraceParameters& parameters, Tracer& tracer) {
    std::vector<TraceState> states;
    try {
        const json file = json::parse(read_text(path));
        if (file.at("format") != format)
            throw Error(ErrorCode::invalid_argument, path.string() + ": not a checkpoint of trace");
        compare(path, file.at("parameters"), parameters);
        compare(path, file.at("directions"), tracer.rows());
        for (const json& state : file.at("states")) {
            TraceState& read = states.emplace_back();
            if (!state.at(0).is_number_unsigned())  // 1e300 as a whole number would be anything
                throw Error(ErrorCode::invalid_argument, path.string() + ": rounds", show_json(state.at(0)),
                            "a whole number, >= 0");
            read.rounds = state.at(0).get<std::uint64_t>();
            for (const json& tally : state.at(1)) read.tallies.push_back({unpack(tally.at(0)), unpack(tally.at(1))});
        }
    } catch (const json::exception&) {
        throw Error(ErrorCode::invalid_argument, path.string() + ": not a checkpoint of trace");
    }
    tracer.restore(std::move(states));
}

}  // namespace aureole::app
