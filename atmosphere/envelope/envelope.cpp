#include <aureole/envelope.h>

#include "common/check.h"
#include "envelope/tell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <variant>

namespace aureole {
namespace {

/// Read off the sweeps of tests/stability/envelope.cpp; tests/stability/envelope_test.cpp holds the models to it.
constexpr std::array<EnvelopeLimit, 9> limits{{
    {1e3, 1e9, "errors above 1 % near the horizon and in twilight: a step of a direction in float is hundreds of metres there"},
    {0, 1.5, "errors up to 12 % near the horizon as seen from space: rays are thousands of scale heights long"},
    {1, 1e12, "errors that were not measured"},
    {0, 0.1,
     "errors up to 10 % of what little light is left: an optical depth of thousands has few digits behind the point in float"},
    {-0.99, 0.99, "errors up to 40 % within a degree of the peak: the cosine of so small an angle has few digits in float"},
    {-1e13, 1e9, "errors above 1 % along the limb: a step of a direction in float is hundreds of metres there"},
    {-9, 90, "steps of 6e-8 of the sun's light, which float tables do not have: the model keeps its sky in half floats"},
    {0, 90,
     "errors up to 6 % of dark geometry: the air before it is the difference of two entries of tables in half floats, which "
     "float tables do not lose"},
    {-12, 90,
     "light that is wrong altogether, of a 1e-9th of the sun's and less: what is left between two nodes of the sun's axis"},
}};

/// Collects what is outside. Names are made of that alone.
struct Finder {
    std::vector<OutsideEnvelope> found{};

    template <class Name>
    void check(EnvelopeAxis axis, double value, const Name& name) {
        const EnvelopeLimit& limit = envelope_limit(axis);
        if (value >= limit.least && value <= limit.greatest) return;
        found.push_back({name(), value, limit.least, limit.greatest, limit.beyond});
    }
};

void check_phase(Finder& finder, const PhaseFunction& phase, std::size_t term) {
    const auto check = [&](double g, const char* name) {
        finder.check(EnvelopeAxis::g, g, [&] { return detail::element("terms", term) + ".phase." + name; });
    };
    if (const auto* p = std::get_if<HenyeyGreensteinPhase>(&phase)) check(p->g, "g");
    if (const auto* p = std::get_if<CornetteShanksPhase>(&phase)) check(p->g, "g");
    if (const auto* p = std::get_if<HenyeyGreensteinDrainePhase>(&phase)) {
        if (p->weight < 1) check(p->g_hg, "g_hg");
        if (p->weight > 0) check(p->g_draine, "g_draine");
    }
}

double greatest_density(const Profile& profile) {
    const auto* table = std::get_if<TabulatedProfile>(&profile);
    return table == nullptr ? 1 : *std::ranges::max_element(table->density);
}

double largest(const Rgb& color) { return std::max({color.r, color.g, color.b}); }

}  // namespace

double detail::greatest_extinction_per_m(const AtmosphereParameters& parameters) {
    Rgb extinction(0);
    for (const DensityTerm& term : parameters.terms)
        extinction += greatest_density(term.profile) *
                      (term.scattering_scale * term.scattering_per_m + term.absorption_scale * term.absorption_per_m);
    return largest(extinction);
}

const EnvelopeLimit& envelope_limit(EnvelopeAxis axis) { return limits.at(static_cast<std::size_t>(axis)); }

std::string OutsideEnvelope::text() const {
    return field + ": " + detail::print(value) + " is outside the envelope of stability, [" + detail::print(least) + ", " +
           detail::print(greatest) + "]: expect " + std::string(beyond);
}

std::vector<OutsideEnvelope> outside_envelope(const AtmosphereParameters& parameters) {
    Finder finder;
    const Planet& planet = parameters.planet;
    finder.check(EnvelopeAxis::bottom_radius_m, planet.bottom_radius_m, [] { return "planet.bottom_radius_m"; });
    finder.check(EnvelopeAxis::shell_over_radius, planet.top_radius_m / planet.bottom_radius_m - 1,
                 [] { return "planet.top_radius_m / planet.bottom_radius_m - 1"; });
    for (std::size_t i = 0; i < parameters.terms.size(); ++i) {
        const DensityTerm& term = parameters.terms[i];
        if (const auto* p = std::get_if<ExponentialProfile>(&term.profile))
            finder.check(EnvelopeAxis::scale_height_m, p->scale_height_m,
                         [&] { return detail::element("terms", i) + ".profile.scale_height_m"; });
        if (largest(term.scattering_scale * term.scattering_per_m) > 0) check_phase(finder, term.phase, i);
    }
    finder.check(EnvelopeAxis::extinction_per_m, detail::greatest_extinction_per_m(parameters),
                 [] { return "terms: extinction in 1/m"; });
    return std::move(finder.found);
}

std::vector<OutsideEnvelope> outside_envelope(const Planet& planet, const Camera& camera, std::span<const Sun> suns,
                                              const KeptInTables& kept) {
    Finder finder;
    const double distance = glm::length(camera.position_m);
    finder.check(EnvelopeAxis::altitude_m, distance - planet.bottom_radius_m,
                 [] { return "camera.position_m: altitude in m"; });
    for (std::size_t i = 0; i < suns.size() && distance > 0 && (kept.half_sky || kept.half_difference || kept.coarse_sun_axis);
         ++i) {
        const glm::dvec3& d = suns[i].direction;
        const double sine = glm::dot(camera.position_m / distance, d / std::hypot(d.x, d.y, d.z));
        const double degrees = std::asin(std::clamp(sine, -1.0, 1.0)) * 180 / std::numbers::pi;
        const std::string_view what = ".direction: elevation in degrees";
        if (kept.half_sky)
            finder.check(EnvelopeAxis::half_sun_elevation_deg, degrees,
                         [&] { return detail::element("suns", i).append(what); });
        if (kept.half_difference)
            finder.check(EnvelopeAxis::half_difference_sun_elevation_deg, degrees,
                         [&] { return detail::element("suns", i).append(what) + ", of geometry"; });
        if (kept.coarse_sun_axis)
            finder.check(EnvelopeAxis::table_sun_elevation_deg, degrees,
                         [&] { return detail::element("suns", i).append(what) + ", in so large or thick an air"; });
    }
    return std::move(finder.found);
}

}  // namespace aureole
