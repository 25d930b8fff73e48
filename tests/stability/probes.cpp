#include "stability/probes.h"

#include "stability/formulas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <type_traits>

namespace aureole::stability {
namespace {

constexpr double pi = std::numbers::pi;

double logarithmic(double low, double high, double u) { return low * std::pow(high / low, u); }
double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }

/// Numbers that floats hold: whatever a function loses, its inputs have not.
struct World {
    explicit World(const Point& u)
        : radius_m(logarithmic(1e3, 1e9, u[0])),
          shell_m(logarithmic(1, 10 * radius_m, u[1])),
          height_m(logarithmic(1e-3, 1e3, u[9]) * shell_m) {
        const double share = u[2] < 0.05 ? 0 : u[2] > 0.95 ? 1 : logarithmic(1e-8, 1, (u[2] - 0.05) / 0.9);
        h = to_float(share * shell_m * 1e-3 * (1 - 1e-7));
        const double radius = radius_m * 1e-3, horizon = -std::sqrt(h * (2 * radius + h)) / (radius + h);
        // Cosines: even, or by decades off the horizon.
        const double off = logarithmic(1e-7, 1, 2 * std::abs(std::fmod(2 * u[3], 1.0) - 0.5));
        mu = to_float(u[3] < 0.5 ? 4 * u[3] - 1 : std::clamp(horizon + (u[3] < 0.75 ? -off : off), -1.0, 1.0));
        t_share = to_float(logarithmic(1e-6, 1, u[4]));
        mu_s = to_float(2 * u[5] - 1);
        const double sines = std::sqrt((1 - mu) * (1 + mu) * (1 - mu_s) * (1 + mu_s));
        nu = to_float(std::clamp(mu * mu_s + sines * std::cos(pi * u[6]), -1.0, 1.0));
        mu_day = to_float(std::max(std::abs(mu_s), 0.01));
        const double day_sines = std::sqrt((1 - mu) * (1 + mu) * (1 - mu_day) * (1 + mu_day));
        nu_day = to_float(std::clamp(std::abs(nu), mu * mu_day - day_sines, mu * mu_day + day_sines));
        x = to_float(logarithmic(1e-6, 1e2, u[7]));
        u01 = to_float(u[7]);
        node = to_float(0.005 + 0.99 * u[7]);
        g = to_float(0.999 * (2 * u[8] - 1));
    }
    double radius_m, shell_m, height_m;
    double h, mu, t_share, mu_s, nu, mu_day, nu_day, x, u01, node, g;  // lengths in km; node: within those of the longest rule
};

Inputs air_of(const World& w) {
    AtmosphereParameters air;
    air.planet.bottom_radius_m = w.radius_m;
    air.planet.top_radius_m = std::min(w.radius_m + std::max(w.shell_m, 1.0), 11 * w.radius_m);
    const double thickness = 0.3 / std::min(w.height_m, w.shell_m);  // vertical optical depth of 0.3 or less
    air.terms = {{"gas", ExponentialProfile{std::clamp(w.height_m, 0.01, 1e12)}, Rgb(thickness), Rgb(0), RayleighPhase{}}};
    return Inputs(air);
}

template <class K>
auto length_of(K& k, decltype(k.atm.radii.x) h, decltype(k.atm.radii.x) mu) {
    return k.hits_ground(h, mu) ? k.distance_to_ground(h, mu) : k.distance_to_top(h, mu);
}
/// Of a ray that meets the ground: the half chord through the planet over the distance to its middle. How far away the ground
/// is follows from the cosine only so well: near the horizon its rounding moves the ground by kilometres.
template <class K>
auto along_root(K& k, decltype(k.atm.radii.x) h, decltype(k.atm.radii.x) mu) {
    const auto b = (k.bottom_radius() + h) * mu;
    return std::sqrt(std::max(1 - k.squares_apart(0, h) / (b * b), decltype(b)(1e-7)));
}
/// Of a ray from high above: by how many scale heights its lowest point moves with its cosine.
template <class K>
auto lowest_condition(K& k, decltype(k.atm.radii.x) h, decltype(k.atm.radii.x) mu) {
    const auto sine = std::sqrt(std::max((1 - mu) * (1 + mu), decltype(mu)(1e-7)));
    return (k.bottom_radius() + h) * std::abs(mu) / sine * k.atm.term_profile[0].x;
}
/// Ends of rays are given to both precisions alike, from double.
struct Ends {
    double length, t, altitude;
    bool ground;
};

using Single = kernels::StabilityFormulas<float>;
using Exact = kernels::StabilityFormulas<double>;
struct Functions {
    Probe probe;
    double (*single)(Single&, const World&, const Ends&);
    double (*exact)(Exact&, const World&, const Ends&);
    double (*scale)(Exact&, const World&, const Ends&);  // null: the value itself
};

#define OF_WORLD(expression)                                                                                       \
    [](auto& k, const World& w, const Ends& e) -> double {                                                         \
        using real [[maybe_unused]] = std::remove_cvref_t<decltype(k.atm.radii.x)>;                                \
        [[maybe_unused]] const real h = static_cast<real>(w.h), mu = static_cast<real>(w.mu);                      \
        [[maybe_unused]] const real mu_s = static_cast<real>(w.mu_s), nu = static_cast<real>(w.nu);                \
        [[maybe_unused]] const real t = static_cast<real>(e.t), x = static_cast<real>(w.x);                        \
        [[maybe_unused]] const real u = static_cast<real>(w.u01), g = static_cast<real>(w.g);                      \
        [[maybe_unused]] const real mu_day = static_cast<real>(w.mu_day), nu_day = static_cast<real>(w.nu_day);    \
        [[maybe_unused]] const real node = static_cast<real>(w.node);                                              \
        [[maybe_unused]] const real h_t = static_cast<real>(e.altitude), end = static_cast<real>(e.length);        \
        [[maybe_unused]] const typename std::remove_cvref_t<decltype(k)>::Ray ray{h, mu, mu_s, nu, end, e.ground}; \
        return static_cast<double>(expression);                                                                    \
    }
#define PROBE(name, bound, expression) \
    Functions { {name, "value", bound}, OF_WORLD(expression), OF_WORLD(expression), nullptr }
#define PROBE_TO(name, bound, relative, expression, scale) \
    Functions { {name, relative, bound}, OF_WORLD(expression), OF_WORLD(expression), OF_WORLD(scale) }

const Functions functions[] = {
    PROBE("horizon_distance", 4, k.horizon_distance(h)),
    PROBE("altitude_of_horizon_distance", 8, k.altitude_of_horizon_distance(k.atm.radii.w* u)),
    PROBE("altitude_position", 8, k.altitude_position(h)),
    PROBE("altitude_at", 16, k.altitude_at(u)),
    PROBE("horizon_mu", 8, k.horizon_mu(h)),
    PROBE_TO("altitude_after", 8, "h + t (abs(mu) + t / 2 r)", k.altitude_after(h, mu, t),
             h + t * (std::abs(mu) + t / (2 * (k.bottom_radius() + h)))),
    PROBE("distance_to_top", 8, k.distance_to_top(h, mu)),
    PROBE("transmittance_mu of 0", 16, k.transmittance_mu(h, real(0))),
    PROBE_TO("distance_to_ground", 8, "value r abs(mu) / root", e.ground ? k.distance_to_ground(h, mu) : real(1),
             e.ground ? end / along_root(k, h, mu) : real(1)),
    PROBE_TO("view_mu_after", 16, "1", k.view_mu_after(ray, t, h_t), real(1)),
    PROBE_TO("sun_mu_after", 16, "1", k.sun_mu_after(ray, t, h_t), real(1)),
    PROBE_TO("transmittance_position", 32, "1", k.transmittance_position(h, mu).x, real(1)),
    PROBE_TO("transmittance_mu", 32, "1", k.transmittance_mu(h, u), real(1)),
    PROBE_TO("sun_position", 8, "1", k.sun_position(mu_s), real(1)),
    PROBE_TO("sun_mu_at", 32, "1", k.sun_mu_at(u), real(1)),
    // Where nodes lie is free, as long as rate and distance are of one map: near the dense end they are told from how far all
    // reach.
    PROBE_TO("map_distance of ray_map", 32, "value + that of u = 1/2",
             k.map_distance(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), node),
             k.map_distance(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), node) +
                 k.map_distance(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), real(0.5))),
    PROBE_TO("map_rate of ray_map", 32, "value + that of u = 1/2",
             k.map_rate(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), node),
             k.map_rate(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), node) +
                 k.map_rate(k.ray_map(end, h, std::abs(mu), k.atm.term_profile[0].x, x), real(0.5))),
    PROBE("growing_step", 8, k.growing_step(t, 5, 16).t),
    PROBE_TO("scatter_direction", 16, "1", k.scatter_direction(k.AZIMUTH_NODES, h).mu, real(1)),
    PROBE_TO("scatter_direction, solid angle", 16, "1", k.scatter_direction(k.AZIMUTH_NODES, h).solid_angle, real(1)),
    PROBE("slice_position", 16, k.slice_position(u, 32)),
    PROBE_TO("term_density", 4, "value (1 + h / H)", k.term_density(0, h),
             k.term_density(0, h) * (1 + h * k.atm.term_profile[0].x)),
    PROBE("mean_transmittance", 8, k.mean_transmittance(glm::vec<3, real>(x)).x),
    PROBE("rayleigh_phase", 4, k.rayleigh_phase(nu)),
    PROBE("henyey_greenstein_phase", 16, k.henyey_greenstein_phase(g, nu)),
    PROBE("cornette_shanks_phase", 16, k.cornette_shanks_phase(g, nu)),
    PROBE("draine_phase", 16, k.draine_phase(g, 10 * u, nu)),
    PROBE_TO("sample_henyey_greenstein", 16, "1 / (1 - g)^2", k.sample_henyey_greenstein(g, u),
             1 / ((1 - std::abs(g)) * (1 - std::abs(g)))),
    PROBE_TO("sample_rayleigh", 16, "1", k.sample_rayleigh(u), real(1)),
    PROBE_TO("visible_share", 16, "1", k.visible_share(4 * u - 2), real(1)),
    PROBE_TO("optical_depth_along", 16, "value (1 + h / H)", k.optical_depth_along(h, mu, t).x,
             k.optical_depth_along(h, mu, t).x*(1 + h * k.atm.term_profile[0].x)),
    PROBE_TO("transmittance_to_top", 16, "1 + r abs(mu) / H sin", k.transmittance_to_top(h, mu).x,
             1 + lowest_condition(k, h, mu)),
    // Towards the sun by day, half a degree after sunrise: how long a ray is in the planet's shadow that it grazes, its numbers
    // say as badly as where it grazes the ground; and a sun on the horizon is seen from a rounding below the top through the
    // root of that.
    PROBE_TO("march, single scattering", 64, "(1 - transmittance) (1 + r abs(mu) / H sin) (1 + h / H)",
             nu_day < 0
                 ? real(1)
                 : k.march(typename std::remove_cvref_t<decltype(k)>::Ray{h, mu, mu_day, nu_day, end, e.ground}).single[0].x,
             (1 - std::exp(-k.march(ray).depth.x)) * (1 + lowest_condition(k, h, mu)) * (1 + h * k.atm.term_profile[0].x)),
    PROBE_TO("aces_fitted", 16, "1", k.aces_fitted(glm::vec<3, real>(x, u, x* u)).x, real(1)),
    PROBE_TO("encode_srgb", 16, "1", k.encode_srgb(glm::vec<3, real>(u)).x, real(1)),
};

const std::vector<Probe>& all_probes() {
    static const std::vector<Probe> all = [] {
        std::vector<Probe> list;
        for (const Functions& f : functions) list.push_back(f.probe);
        return list;
    }();
    return all;
}

}  // namespace

std::span<const Probe> probes() { return all_probes(); }

struct Prober::Impl {
    Formulas<float> single;
    Formulas<double> exact;
};
Prober::Prober() : impl_(std::make_unique<Impl>()) {
    Formulas<float>::rule(impl_->single.kernel.zenith_quadrature, impl_->single.kernel.ZENITH_NODES);
    Formulas<double>::rule(impl_->exact.kernel.zenith_quadrature, impl_->exact.kernel.ZENITH_NODES);
}
Prober::~Prober() = default;

double Prober::error(std::size_t probe, const Point& at) {
    const World w(at);
    const Inputs in = air_of(w);
    auto& single = impl_->single.set(in);
    auto& exact = impl_->exact.set(in);
    const double length = to_float(length_of(exact, w.h, w.mu)), t = to_float(w.t_share * length);
    const Ends ends{length, t, to_float(exact.altitude_after(w.h, w.mu, t)), exact.hits_ground(w.h, w.mu)};
    const Functions& f = functions[probe];
    const double wanted = f.exact(exact, w, ends), found = f.single(single, w, ends);
    const double scale = std::abs(f.scale == nullptr ? wanted : f.scale(exact, w, ends));
    if (std::isnan(found)) return std::numeric_limits<double>::infinity();
    if (scale < 1e-30) return 0;
    return std::abs(found - wanted) / scale / std::numeric_limits<float>::epsilon();
}

std::string Prober::text(const Point& at) {
    const World w(at);
    std::ostringstream text;
    text.precision(4);
    text << "R " << w.radius_m << " m, shell " << w.shell_m << " m, H " << w.height_m << " m, h " << 1e3 * w.h << " m, mu "
         << w.mu << ", mu_s " << w.mu_s << ", nu " << w.nu << ", t " << w.t_share << ", x " << w.x << ", g " << w.g;
    return text.str();
}

}  // namespace aureole::stability
