// The geometry of rays: distances, altitudes, shadows and the axes of tables, from metres of air on a pebble to a planet of a
// thousand suns.
#include "stability/formulas.h"
#include "stability/worst.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace aureole;
using namespace aureole::stability;

namespace {

constexpr double km = 1e-3;

/// What rounding may do to an altitude at the distance t of a ray that starts at h: each of the three terms of the altitude
/// form is exact to some steps.
template <class real>
double altitude_rounding(double radius, double h, double mu, double t) {
    constexpr double step = std::numeric_limits<real>::epsilon();
    return 8 * step * (h + t * std::abs(mu) + 0.5 * t * t / (radius + h)) + std::numeric_limits<float>::min();
}

/// Relative, as a share of `steps` of the precision.
template <class real>
double apart(double a, double b, double steps) {
    if (a == b) return 0;
    return std::abs(a - b) / (steps * std::numeric_limits<real>::epsilon() * std::max(std::abs(a), std::abs(b)));
}

bool within(double x, double low, double high) { return x >= low && x <= high; }

/// A planet and a ray of the case, in kilometres, rounded to what the kernel gets.
template <class real>
struct Place {
    Place(Formulas<real>& formulas, const Case& c, double scale = 1) : kernel(formulas.kernel) {
        Inputs in(without_air(c.planet()));
        in.air.radii *= static_cast<float>(scale);
        in.air.tables.z = c.random(501) < 0.5 ? 0.0F : 31.0F;
        formulas.set(in);
        radius = static_cast<real>(in.air.radii.x), shell = static_cast<real>(in.air.radii.z);
        h = std::min(static_cast<real>(static_cast<float>(c.altitude_in_air_m() * km * scale)), shell);
        mu = static_cast<real>(static_cast<float>(std::cos(c.view_zenith())));
        mu_s = static_cast<real>(static_cast<float>(std::cos(c.sun_zenith())));
        const double sines = std::sin(c.view_zenith()) * std::sin(c.sun_zenith()) * std::cos(c.sun_azimuth());
        nu = static_cast<real>(
            static_cast<float>(std::clamp(std::cos(c.view_zenith()) * std::cos(c.sun_zenith()) + sines, -1.0, 1.0)));
    }
    [[nodiscard]] real length() const {
        return kernel.hits_ground(h, mu) ? kernel.distance_to_ground(h, mu) : kernel.distance_to_top(h, mu);
    }

    kernels::StabilityFormulas<real>& kernel;
    real radius, shell, h, mu, mu_s, nu;
};

template <class real>
void check_distances(Ledger& ledger, const Case& c, const Place<real>& p) {
    auto& k = p.kernel;
    const double slack = altitude_rounding<real>(p.radius, p.h, p.mu, k.distance_to_top(p.h, p.mu));
    const real to_top = k.distance_to_top(p.h, p.mu);
    ledger.check("distance to the top is finite and not negative", c, within(to_top, 0, 1e30));
    if (!k.hits_ground(p.h, p.mu))
        ledger.add("at the distance to the top lies the top", c,
                   std::abs(static_cast<double>(k.altitude_after(p.h, p.mu, to_top)) - p.shell) /
                       (slack + 8 * static_cast<double>(std::numeric_limits<real>::epsilon()) * p.shell));
    const real steeper = std::min(p.mu + real(0.01), real(1));
    ledger.check("the steeper, the nearer the top", c, k.distance_to_top(p.h, steeper) <= to_top * (1 + real(1e-6)));

    ledger.check("the horizon is at or below the horizontal", c, within(k.horizon_mu(p.h), -1, 0));
    if (!k.hits_ground(p.h, p.mu)) return;
    const real to_ground = k.distance_to_ground(p.h, p.mu);
    ledger.check("distance to the ground is finite and not negative", c, within(to_ground, 0, 1e30));
    ledger.check("the ground is no farther than the horizon", c,
                 to_ground <= k.horizon_distance(p.h) * (1 + 4 * std::numeric_limits<real>::epsilon()));
    ledger.check("the ground is no nearer than straight down", c,
                 to_ground >= p.h * (1 - 32 * std::numeric_limits<real>::epsilon()));
}

template <class real>
void check_altitudes(Ledger& ledger, const Case& c, const Place<real>& p) {
    auto& k = p.kernel;
    const real length = p.length();
    const real t = length * static_cast<real>(c.distance_share());
    const real h = k.altitude_after(p.h, p.mu, t);
    const double slack = altitude_rounding<real>(p.radius, p.h, p.mu, t);
    ledger.check("altitude along a ray is finite and not negative", c, within(h, 0, 1e30));
    const double root_slack = altitude_rounding<real>(p.radius, p.h, p.mu, length);
    ledger.add("a ray stays in the shell", c,
               (static_cast<double>(h) - p.shell) /
                   (root_slack + 8 * static_cast<double>(std::numeric_limits<real>::epsilon()) * p.shell));
    ledger.check("cosine along a ray is one", c,
                 within(k.view_mu_after({p.h, p.mu, p.mu_s, p.nu, length, false}, t, h), -1, 1) &&
                     within(k.sun_mu_after({p.h, p.mu, p.mu_s, p.nu, length, false}, t, h), -1, 1));
    ledger.add(
        "at no distance lies the start", c,
        std::abs(static_cast<double>(k.altitude_after(p.h, p.mu, 0)) - p.h) / altitude_rounding<real>(p.radius, p.h, p.mu, 0));
    const real back = k.distance_to_altitude(p.h, p.mu, h, p.mu >= 0 || t * p.mu > -(p.radius + p.h) * p.mu * p.mu);
    ledger.check("distance to an altitude is finite", c, std::isfinite(static_cast<double>(back)));
    if (p.mu > 0) {  // horizontal rays are at their lowest point, where altitude says nothing about distance
        const double found = k.altitude_after(p.h, p.mu, back);
        ledger.add("at the distance to an altitude lies that altitude", c,
                   std::abs(found - h) / (2 * slack + 8 * std::numeric_limits<real>::epsilon() * static_cast<double>(h)));
    }
    const real before = k.altitude_after(p.h, std::abs(p.mu), t * real(0.5));
    const real after = k.altitude_after(p.h, std::abs(p.mu), t);
    ledger.check("a ray upwards rises", c, after - before >= -static_cast<real>(slack));
}

template <class real>
void check_shadow(Ledger& ledger, const Case& c, const Place<real>& p) {
    const auto shadow = p.kernel.shadow_interval({p.h, p.mu, p.mu_s, p.nu, p.length(), p.kernel.hits_ground(p.h, p.mu)});
    ledger.check("the planet's shadow is a part of the ray", c,
                 within(shadow.x, 0, p.length()) && within(shadow.y, shadow.x, p.length()));
    if (p.mu_s > 0 && p.nu >= 0) ledger.check("by day, on the way to the sun there is no shadow", c, shadow.x == shadow.y);
}

template <class real>
void check_axes(Ledger& ledger, const Case& c, const Place<real>& p) {
    auto& k = p.kernel;
    constexpr real one = 1 + 8 * std::numeric_limits<real>::epsilon();
    const real position = k.altitude_position(p.h);
    ledger.check("position of an altitude is in [0, 1]", c, within(position, 0, 1 + 4e-7));
    ledger.check("altitude of a position is in the shell", c,
                 within(k.altitude_at(static_cast<real>(c.random(500))), 0, p.shell * one));
    // The stretch multiplies the rounding of positions near the top.
    ledger.add("altitude and its position undo each other", c,
               apart<real>(k.altitude_at(position), p.h, 8 + 4 * static_cast<double>(k.atm.tables.z)));
    const real higher = std::min(p.h * real(1.01), p.shell);
    ledger.check("the higher, the farther the horizon", c, k.horizon_distance(higher) >= k.horizon_distance(p.h));
    const auto at = k.transmittance_position(p.h, std::max(p.mu, k.horizon_mu(p.h)));
    ledger.check("transmittance position is in [0, 1]", c, within(at.x, 0, 1) && within(at.y, 0, 1 + 4e-7));
    const real mu = k.transmittance_mu(p.h, static_cast<real>(c.random(502)));
    ledger.check("transmittance cosine is one", c, within(mu, -1, 1));
    ledger.check("sun position is in [0, 1]", c, within(k.sun_position(p.mu_s), -1e-6, 1 + 1e-6));
    ledger.check("sun cosine of a position is one", c, within(k.sun_mu_at(static_cast<real>(c.random(503))), -1, 1));
}

/// Lengths times a power of two are lengths times a power of two, to the bit.
template <class real>
void check_scale(Ledger& ledger, const Case& c, const Place<real>& a, const Place<real>& b, real s) {
    const auto same = [&](real x, real y) { return x * s == y; };
    ledger.check("unit scale: distances", c,
                 same(a.kernel.distance_to_top(a.h, a.mu), b.kernel.distance_to_top(b.h, b.mu)) &&
                     same(a.kernel.horizon_distance(a.h), b.kernel.horizon_distance(b.h)) && same(a.length(), b.length()));
    const real t = a.length() * real(0.625);
    ledger.check("unit scale: altitudes", c,
                 same(a.kernel.altitude_after(a.h, a.mu, t), b.kernel.altitude_after(b.h, b.mu, t * s)));
    ledger.check("unit scale: positions", c,
                 a.kernel.altitude_position(a.h) == b.kernel.altitude_position(b.h) &&
                     a.kernel.transmittance_position(a.h, a.mu) == b.kernel.transmittance_position(b.h, b.mu) &&
                     a.kernel.horizon_mu(a.h) == b.kernel.horizon_mu(b.h));
    const auto shadow_a = a.kernel.shadow_interval({a.h, a.mu, a.mu_s, a.nu, a.length(), false});
    const auto shadow_b = b.kernel.shadow_interval({b.h, b.mu, b.mu_s, b.nu, b.length(), false});
    ledger.check("unit scale: shadow", c, same(shadow_a.x, shadow_b.x) && same(shadow_a.y, shadow_b.y));
}

}  // namespace

TEST_CASE_TEMPLATE("stability, geometry: finite, in range, monotone, the same in any unit", real, float, double) {
    Ledger ledger(sizeof(real) == 4 ? "geometry in float" : "geometry in double");
    const Range range = cases(30000);
    Formulas<real> one, other;
    for (std::uint64_t i = range.begin; i < range.end; ++i) {
        const Case c(i);
        const Place<real> place(one, c), larger(other, c, 16);
        check_distances(ledger, c, place);
        check_altitudes(ledger, c, place);
        check_shadow(ledger, c, place);
        check_axes(ledger, c, place);
        check_scale(ledger, c, place, larger, real(16));
    }
    ledger.verify();
}
