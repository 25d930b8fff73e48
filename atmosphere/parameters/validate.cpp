#include "parameters/validate.h"

#include "common/check.h"
#include "phase/distinct.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole {
namespace detail {
namespace {

// Ranges are as wide as float arithmetic in kilometres allows; each is stated at its field in parameters.h.
constexpr double far_m = 1e12;
constexpr double sharpest_g = 0.999;

void check_increasing(const std::string& field, const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) reject(element(field, i), print(values[i]), "greater than " + print(values[i - 1]));
}

/// The two columns of a table: as long as each other, each value in its range, the first strictly increasing.
struct Column {
    const char* name;
    const std::vector<double>& values;
    double low, high;
};
void check_table(const std::string& field, const Column& x, const Column& y) {
    const std::string x_field = field + "." + x.name, y_field = field + "." + y.name;
    check_count(x_field, x.values.size(), 2, 4096);
    check_count(y_field, y.values.size(), x.values.size(), x.values.size());
    for (std::size_t i = 0; i < x.values.size(); ++i) check(element(x_field, i), x.values[i], x.low, x.high);
    for (std::size_t i = 0; i < y.values.size(); ++i) check(element(y_field, i), y.values[i], y.low, y.high);
    check_increasing(x_field, x.values);
}

struct ProfileCheck {
    const std::string& field;

    void operator()(const ExponentialProfile& p) const { check(field + ".scale_height_m", p.scale_height_m, 0.01, far_m); }
    void operator()(const TentProfile& p) const {
        check(field + ".center_m", p.center_m, -far_m, far_m);
        check(field + ".half_width_m", p.half_width_m, 0.01, far_m);
    }
    void operator()(const TabulatedProfile& p) const {
        check_table(field, {"altitude_m", p.altitude_m, -far_m, far_m}, {"density", p.density, 0, 1e6});
    }
};

struct PhaseCheck {
    const std::string& field;

    void operator()(const RayleighPhase&) const {}
    void operator()(const HenyeyGreensteinPhase& p) const { check(field + ".g", p.g, -sharpest_g, sharpest_g); }
    void operator()(const CornetteShanksPhase& p) const { check(field + ".g", p.g, -sharpest_g, sharpest_g); }
    void operator()(const HenyeyGreensteinDrainePhase& p) const {
        check(field + ".g_hg", p.g_hg, -sharpest_g, sharpest_g);
        check(field + ".g_draine", p.g_draine, -sharpest_g, sharpest_g);
        check(field + ".alpha", p.alpha, 0, 1e4);
        check(field + ".weight", p.weight, 0, 1);
    }
    void operator()(const TabulatedPhase& p) const {
        constexpr double pi = std::numbers::pi, slack = 1e-6;  // of tables written with few digits
        check_table(field, {"angle_rad", p.angle_rad, 0, pi + slack}, {"value", p.value, 0, 1e100});
        check(element(field + ".angle_rad", 0), p.angle_rad.front(), 0, slack);
        check(element(field + ".angle_rad", p.angle_rad.size() - 1), p.angle_rad.back(), pi - slack, pi + slack);
        for (const double v : p.value)
            if (v > 0) return;
        reject(field + ".value", "0 everywhere", "at least one value > 0");
    }
};

void check_scale(const std::string& field, double scale, const Rgb& coefficient) {
    check(field, scale, 0, 1e6);
    const double greatest = std::max({coefficient.r, coefficient.g, coefficient.b});
    if (scale * greatest > 1e6)
        reject(field, print(scale), "a product of at most 1e6 1/m with the coefficient, " + print(greatest));
}

void check_term(const std::string& field, const DensityTerm& term) {
    std::visit(ProfileCheck{field + ".profile"}, term.profile);
    check_rgb(field + ".scattering_per_m", term.scattering_per_m, 0, 1e6);
    check_rgb(field + ".absorption_per_m", term.absorption_per_m, 0, 1e6);
    check_scale(field + ".scattering_scale", term.scattering_scale, term.scattering_per_m);
    check_scale(field + ".absorption_scale", term.absorption_scale, term.absorption_per_m);
    check_phase(field + ".phase", term.phase);
}

}  // namespace

void check_phase(const std::string& field, const PhaseFunction& phase) { std::visit(PhaseCheck{field}, phase); }

void check_planet(const std::string& field, const Planet& planet) {
    check(field + ".bottom_radius_m", planet.bottom_radius_m, 1e3, far_m);
    check(field + ".top_radius_m", planet.top_radius_m, planet.bottom_radius_m + 1, 11 * planet.bottom_radius_m);
    check_rgb(field + ".ground_albedo", planet.ground_albedo, 0, 1);
}

void check_sun(const FieldName& field, const Sun& sun) {
    const glm::dvec3& d = sun.direction;
    check_xyz(field + ".direction", d, -1e100, 1e100);
    if (!(std::hypot(d.x, d.y, d.z) >= 1e-100)) reject(field + ".direction", "(0, 0, 0)", "a length of at least 1e-100");
    check_rgb(field + ".irradiance", sun.irradiance, 0, 1e20);
    check(field + ".angular_radius_rad", sun.angular_radius_rad, 0, std::numbers::pi / 4);
    if (sun.limb_darkening != LimbDarkening::none && sun.limb_darkening != LimbDarkening::neckel94)
        reject(field + ".limb_darkening", std::to_string(static_cast<int>(sun.limb_darkening)), "none or neckel94");
}

}  // namespace detail

void validate(const AtmosphereParameters& parameters) {
    detail::check_planet("planet", parameters.planet);
    for (std::size_t i = 0; i < parameters.terms.size(); ++i)
        detail::check_term(detail::element("terms", i), parameters.terms[i]);
    const std::size_t phases = detail::distinct_phases(parameters.terms).size();
    if (phases > AtmosphereParameters::max_phase_functions)
        detail::reject("terms", std::to_string(phases) + " different phase functions of scattering terms",
                       "at most " + std::to_string(AtmosphereParameters::max_phase_functions));
}

void validate(const Sun& sun) { detail::check_sun("sun", sun); }

}  // namespace aureole
