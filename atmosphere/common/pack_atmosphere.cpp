#include "common/pack_atmosphere.h"

#include "common/formulas.h"
#include "common/resample.h"
#include "medium/merge.h"
#include "phase/distinct.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole::detail {
namespace {

using Air = kernels::AirFormulas<double>;
using Vec4 = glm::dvec4;

template <class... F>
struct Overload : F... {
    using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;  // clang 14 deduces no aggregates

constexpr double per_km = 1000;  // 1/m to 1/km
constexpr double km = 1e-3;      // m to km

/// theta = pi s; the integral over the sphere is that of 2 pi sin(theta) dtheta.
const TableAxis& phase_axis() {
    static const TableAxis axis{
        .x_of_s = [](double s) { return std::numbers::pi * s; },
        .s_of_x = [](double theta) { return theta / std::numbers::pi; },
        .weight = [](double s) { return 2 * std::numbers::pi * std::numbers::pi * std::sin(std::numbers::pi * s); },
    };
    return axis;
}

/// h = highest s^2; a column is the integral of dh = 2 highest s ds.
TableAxis profile_axis(double highest) {
    return {
        .x_of_s = [highest](double s) { return highest * s * s; },
        .s_of_x = [highest](double h) { return std::sqrt(h / highest); },
        .weight = [highest](double s) { return 2 * highest * s; },
    };
}

/// One row of the phase table: any scale in, an integral of 1 over the sphere out.
std::vector<double> phase_row(const TabulatedPhase& phase) {
    const double peak = *std::max_element(phase.value.begin(), phase.value.end());
    std::vector<double> value = phase.value;
    for (double& v : value) v /= peak;  // neither overflows nor vanishes in the sum
    std::vector<double> row = resample(phase.angle_rad, value, table_width, phase_axis());
    const double whole = integral(row, phase_axis());
    for (double& v : row) v /= whole;
    return row;
}

/// Of a table so far: the place of its next row.
std::size_t rows_of(const auto& table) { return table.size() / table_width; }

void append(std::vector<double>& table, const std::vector<double>& row) { table.insert(table.end(), row.begin(), row.end()); }

/// Kind and parameters of a phase function (phase.glsl); a tabulated one becomes a row of the table, normalized.
int pack_phase(const PhaseFunction& phase, Vec4& parameters, std::vector<double>& table) {
    parameters = Vec4(0);
    return std::visit(Overload{
                          [](const RayleighPhase&) { return Air::PHASE_RAYLEIGH; },
                          [&](const HenyeyGreensteinPhase& p) {
                              parameters.x = p.g;
                              return Air::PHASE_HENYEY_GREENSTEIN;
                          },
                          [&](const CornetteShanksPhase& p) {
                              parameters.x = p.g;
                              return Air::PHASE_CORNETTE_SHANKS;
                          },
                          [&](const HenyeyGreensteinDrainePhase& p) {
                              parameters = {p.g_hg, p.g_draine, p.alpha, p.weight};
                              return Air::PHASE_HG_DRAINE;
                          },
                          [&](const TabulatedPhase& p) {
                              parameters.x = static_cast<double>(rows_of(table));
                              append(table, phase_row(p));
                              return Air::PHASE_TABULATED;
                          },
                      },
                      phase);
}

int pack_profile(const Profile& profile, double highest_km, Vec4& parameters, std::vector<double>& table) {
    parameters = Vec4(0);
    return std::visit(Overload{
                          [&](const ExponentialProfile& p) {
                              parameters.x = 1 / (p.scale_height_m * km);
                              return Air::PROFILE_EXPONENTIAL;
                          },
                          [&](const TentProfile& p) {
                              parameters.x = p.center_m * km;
                              parameters.y = 1 / (p.half_width_m * km);
                              return Air::PROFILE_TENT;
                          },
                          [&](const TabulatedProfile& p) {
                              parameters.w = static_cast<double>(rows_of(table));
                              std::vector<double> altitude_km = p.altitude_m;
                              for (double& h : altitude_km) h *= km;
                              append(table, resample(altitude_km, p.density, table_width, profile_axis(highest_km)));
                              return Air::PROFILE_TABULATED;
                          },
                      },
                      profile);
}

/// Where the profile table ends: inside the shell, and so that its last cell lies beyond the last change of any profile. The
/// last texel, which holds from there up, is then the value beyond the samples and no mean of what is below.
double highest_tabulated_km(const std::vector<DensityTerm>& terms, double shell_km) {
    double last_change = 0;
    for (const DensityTerm& term : terms)
        if (const auto* table = std::get_if<TabulatedProfile>(&term.profile))
            last_change = std::max(last_change, table->altitude_m.back() * km);
    constexpr double last_cell = (table_width - 1.0) / (table_width - 2.0);
    const double highest = last_change * last_cell * last_cell;
    return highest > 0 ? std::min(highest, shell_km) : shell_km;
}

void pack_phases(ExactAtmosphere& air) {
    AirStructure& structure = air.structure;
    structure.phase_count = static_cast<int>(air.phases.size());
    for (int c = 0; c < structure.phase_count; ++c) {
        const int kind = pack_phase(air.phases[static_cast<std::size_t>(c)], air.block.phase_parameters[c], air.phase_table);
        structure.phase_kinds |= kind << (4 * c);
        if (kind != Air::PHASE_RAYLEIGH) structure.sharp_phases |= 1u << c;
    }
}

/// Stretch of the tables' axis of altitude: 0 while the lowest exponential term reaches a tenth of the axis; below that a power
/// of two, less 1, so that tables keep their axes while the air's numbers change a little.
double altitude_stretch(const std::vector<DensityTerm>& terms, const Planet& planet) {
    constexpr double next_to_nothing = 0.003;  // vertical optical depth of a term that need not be resolved
    constexpr double wanted = 0.1, most = 32;
    const auto horizon = [&](double h) { return std::sqrt(h * (2 * planet.bottom_radius_m + h)); };
    const double top = horizon(planet.top_radius_m - planet.bottom_radius_m);
    double lowest = wanted;
    for (const DensityTerm& term : terms) {
        const auto* layer = std::get_if<ExponentialProfile>(&term.profile);
        const Rgb extinction = term.scattering_per_m + term.absorption_per_m;
        if (layer == nullptr || std::max({extinction.r, extinction.g, extinction.b}) * layer->scale_height_m < next_to_nothing)
            continue;
        lowest = std::min(lowest, horizon(layer->scale_height_m) / top);
    }
    return std::min(std::exp2(std::ceil(std::log2(wanted / lowest))), most) - 1;
}

void pack_terms(const AtmosphereParameters& parameters, ExactAtmosphere& air) {
    const std::vector<DensityTerm> terms = merged_terms(parameters);
    air.block.tables.z = altitude_stretch(terms, parameters.planet);
    air.block.tables.y = highest_tabulated_km(terms, air.block.radii.z);
    air.structure.term_count = static_cast<int>(terms.size());
    unsigned kinds = 0, phases = 0;
    for (unsigned i = 0; i < terms.size(); ++i) {
        const DensityTerm& term = terms[i];
        const int kind = pack_profile(term.profile, air.block.tables.y, air.block.term_profile[i], air.profile_table);
        kinds |= static_cast<unsigned>(kind) << (2 * i);
        if (scatters(term)) phases |= static_cast<unsigned>(phase_index(air.phases, term.phase)) << (2 * i);
        air.block.term_scattering[i] = Vec4(term.scattering_per_m * per_km, 0);
        air.block.term_extinction[i] = Vec4((term.scattering_per_m + term.absorption_per_m) * per_km, 0);
    }
    air.structure.term_kinds = static_cast<int>(kinds);
    air.structure.term_phases = static_cast<int>(phases);
    air.block.tables.x = static_cast<double>(rows_of(air.profile_table));
}

void pack_planet(const Planet& planet, Blocks<double>::AtmosphereBlock& block) {
    const double bottom = planet.bottom_radius_m * km, shell = (planet.top_radius_m - planet.bottom_radius_m) * km;
    block.radii = {bottom, planet.top_radius_m * km, shell, std::sqrt(shell * (2 * bottom + shell))};
    block.ground_albedo = Vec4(planet.ground_albedo, 0);
}

void pack_moments(const ExactAtmosphere& air, Blocks<double>::AtmosphereBlock& block) {
    constexpr int count = 12;
    for (int c = 0; c < air.structure.phase_count; ++c) {
        const std::vector<double> moments = legendre_moments(air.phases[static_cast<std::size_t>(c)], count);
        for (int l = 0; l < count; ++l) block.phase_moments[3 * c + l / 4][l % 4] = moments[static_cast<std::size_t>(l)];
    }
}

std::vector<float> to_float(const std::vector<double>& table) {
    std::vector<float> result(table.size());
    std::transform(table.begin(), table.end(), result.begin(), [](double v) { return static_cast<float>(v); });
    return result;
}

}  // namespace

ExactAtmosphere pack_exact(const AtmosphereParameters& parameters) {
    ExactAtmosphere air;
    air.phases = distinct_phases(parameters.terms);
    if (air.phases.empty()) air.phases.emplace_back(RayleighPhase{});
    pack_phases(air);
    pack_planet(parameters.planet, air.block);
    pack_terms(parameters, air);
    return air;
}

ExactAtmosphere pack_exact(const PhaseFunction& phase) {
    ExactAtmosphere air;
    air.phases = {phase};
    pack_phases(air);
    return air;
}

PackedAtmosphere pack_atmosphere(const AtmosphereParameters& parameters) {
    validate(parameters);
    ExactAtmosphere air = pack_exact(parameters);
    pack_moments(air, air.block);
    PackedAtmosphere packed;
    static_cast<AirStructure&>(packed) = air.structure;
    packed.block = round_block<AtmosphereBlock>(air.block);
    packed.profile_table = to_float(air.profile_table);
    packed.phase_table = to_float(air.phase_table);
    packed.profile_rows = static_cast<int>(rows_of(packed.profile_table));
    packed.phase_rows = static_cast<int>(rows_of(packed.phase_table));
    return packed;
}

}  // namespace aureole::detail
