// Scattering by molecules of dry air: Bodhaine, Wood, Dutton & Slusser 1999, equation numbers theirs.
#include <aureole/spectrum.h>

#include "common/check.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace aureole::spectrum {
namespace {

void check_air(double nm, double co2_ppm) {
    aureole::detail::check("nm", nm, 230, 1690);
    aureole::detail::check("co2_ppm", co2_ppm, 0, 1e6);
}

/// 1 / lambda^2, in 1/um^2.
double inverse_square(double nm) { return 1e6 / (nm * nm); }

}  // namespace

double refractivity(double nm, double co2_ppm) {
    check_air(nm, co2_ppm);
    const double k = inverse_square(nm);
    const double at_300_ppm = 1e-8 * (8060.51 + 2480990 / (132.274 - k) + 17455.7 / (39.32957 - k));  // (18)
    return at_300_ppm * (1 + 0.54 * (co2_ppm - 300) * 1e-6);                                          // (19)
}

double king_factor(double nm, double co2_ppm) {
    check_air(nm, co2_ppm);
    const double k = inverse_square(nm);
    const double nitrogen = 1.034 + 3.17e-4 * k;                       // (5)
    const double oxygen = 1.096 + 1.385e-3 * k + 1.448e-4 * k * k;     // (6)
    const double argon = 1, co2 = 1.15, co2_percent = co2_ppm * 1e-4;  // (23), with parts by volume in percent
    return (78.084 * nitrogen + 20.946 * oxygen + 0.934 * argon + co2_percent * co2) / (78.084 + 20.946 + 0.934 + co2_percent);
}

double rayleigh_cross_section(double nm, double co2_ppm) {
    const double n = 1 + refractivity(nm, co2_ppm);
    const double polarizability = (n * n - 1) / (n * n + 2) / standard_number_density;
    const double length = nm * 1e-9;
    const double pi = glm::pi<double>();
    return 24 * pi * pi * pi * polarizability * polarizability / std::pow(length, 4) * king_factor(nm, co2_ppm);  // (2)
}

double rayleigh_scattering(double nm, double co2_ppm) { return standard_number_density * rayleigh_cross_section(nm, co2_ppm); }

double angstrom_optical_depth(double nm, double beta, double alpha) {
    aureole::detail::check("nm", nm, 100, 1e5);
    aureole::detail::check("beta", beta, 0, 1e3);
    aureole::detail::check("alpha", alpha, -4, 4);
    return beta * std::pow(nm / 1000, -alpha);
}

}  // namespace aureole::spectrum
