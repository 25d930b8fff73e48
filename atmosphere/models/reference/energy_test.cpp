// The path tracer loses nothing and makes nothing.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/traced.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double km = 1000;

/// Molecules and an aerosol over the whole planet; with absorption in air and ground, or none at all.
AtmosphereParameters air_of(bool absorbing) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(absorbing ? 0.4 : 1.0);
    air.terms = {{"molecules", ExponentialProfile{8 * km}, Rgb(5.802e-6, 13.558e-6, 33.1e-6), Rgb(0), RayleighPhase{}},
                 {"dust", ExponentialProfile{3 * km}, Rgb(40e-6), Rgb(absorbing ? 20e-6 : 0.0), CornetteShanksPhase{0.3}}};
    return air;
}

/// A sequence that fills the unit square evenly (Roberts' R2), from a shifted start.
struct Even {
    double shift_x, shift_y;
    [[nodiscard]] glm::dvec2 operator()(int i) const {
        const double x = shift_x + i * 0.7548776662466927, y = shift_y + i * 0.5698402909980532;
        return {x - std::floor(x), y - std::floor(y)};
    }
};

/// What the accounts are drawn from.
struct Effort {
    int tries;       ///< Independent ones, by whose scatter the error is known.
    int places;      ///< Of each account: altitude and sun.
    int directions;  ///< From each place.
    int paths;       ///< In each direction.
    int parts;       ///< Of the first order: what it misses is far below the error.
};

/// The planet's accounts per unit of the sun's irradiance, each term over the light that meets the shell, for one sequence.
class Accounts {
public:
    Accounts(Sky& sky, const AtmosphereParameters& air, const Effort& effort, int replicate)
        : sky_(sky),
          air_(air),
          effort_(effort),
          replicate_(replicate),
          shell_{air.planet.bottom_radius_m, air.planet.top_radius_m, {}} {}

    /// Light that leaves without having met anything.
    [[nodiscard]] Rgb straight() const {
        const double bottom = air_.planet.bottom_radius_m, top = air_.planet.top_radius_m;
        Rgb total(0);
        for (int part = 0; part < 8; ++part)
            for (const Node& b : gauss_nodes(bottom + (top - bottom) * part / 8, bottom + (top - bottom) * (part + 1) / 8)) {
                const double mu = -std::sqrt(1 - std::pow(b.at / top, 2));
                total += b.weight * 2 * b.at / (top * top) * transmittance(top - bottom, mu);
            }
        return total;
    }
    /// Light that leaves after all.
    [[nodiscard]] Rgb out() {
        const double thickness = air_.planet.top_radius_m - air_.planet.bottom_radius_m;
        return average([&](double, double sun_mu) {
                   // Upwards through the top: seen by looking down, weighted by the cosine.
                   return seen(thickness, sun_mu, [](double u) { return -std::sqrt(u); }) * pi;
               }) *
               4.0;
    }
    [[nodiscard]] Rgb absorbed_by_ground() {
        const double share = std::pow(air_.planet.bottom_radius_m / air_.planet.top_radius_m, 2);
        return average([&](double, double sun_mu) {
                   const Rgb beam = sun_mu > 0 ? sun_mu * transmittance(0, sun_mu) : Rgb(0);
                   return beam + seen(0, sun_mu, [](double u) { return std::sqrt(u); }) * pi;
               }) *
               (Rgb(1) - air_.planet.ground_albedo) * (4 * share);
    }
    [[nodiscard]] Rgb absorbed_by_air() {
        const double bottom = air_.planet.bottom_radius_m, top = air_.planet.top_radius_m, height = 3 * km;
        const double most = 1 - std::exp(-(top - bottom) / height);
        return average([&](double u, double sun_mu) {
                   // Altitudes are drawn as the absorber lies.
                   const double h = -height * std::log(1 - most * u);
                   const bool hidden = shell_.hits_ground(h, sun_mu);
                   const Rgb field = (hidden ? Rgb(0) : transmittance(h, sun_mu)) +
                                     seen(h, sun_mu, [](double v) { return 1 - 2 * v; }) * (4 * pi);
                   return field * air_.terms[1].absorption_per_m * (height * most) * std::pow((bottom + h) / top, 2);
               }) *
               4.0;
    }

private:
    [[nodiscard]] Rgb transmittance(double altitude, double mu) const {
        Rgb depth(0);
        Shell shell = shell_;
        for (const DensityTerm& term : air_.terms) {
            const double scale = std::get<ExponentialProfile>(term.profile).scale_height_m;
            shell.density = [scale](Real h) { return std::exp(-h / static_cast<Real>(scale)); };
            depth += static_cast<double>(shell.column_to_top(altitude, mu)) * (term.scattering_per_m + term.absorption_per_m);
        }
        return glm::exp(-depth);
    }
    /// Mean over places, which follow from altitude (the sequence's x) and sun (its y within strata of the cosine).
    template <class F>
    [[nodiscard]] Rgb average(const F& f) {
        const int places = effort_.places;
        const Even even{replicate_ * 0.6180339887, replicate_ * 0.3247179572};
        Rgb total(0);
        for (int i = 0; i < places; ++i) total += f(even(i).x, 2 * (i + even(i).y) / places - 1);
        return total / static_cast<double>(places);
    }
    /// Mean radiance of directions whose zenith cosines are drawn by `cosine`. Other paths at each place.
    template <class Cosine>
    [[nodiscard]] Rgb seen(double altitude, double sun_mu, const Cosine& cosine) {
        const int count = effort_.directions;
        sky_.air().set_frame(static_cast<std::uint64_t>(++frame_));
        sky_.stand(altitude, sun_at(std::acos(sun_mu)));
        const Even even{frame_ * 0.6180339887, frame_ * 0.3247179572};
        std::vector<glm::dvec3> directions;
        for (int i = 0; i < count; ++i) {
            const double zenith = std::acos(cosine(even(i).x));
            directions.push_back(direction(zenith, 2 * pi * even(i).y));
        }
        Rgb total(0);
        for (const Rgb& value : sky_.radiance(directions)) total += value;
        return total / static_cast<double>(count);
    }

    Sky& sky_;
    const AtmosphereParameters& air_;
    Effort effort_;
    int replicate_;
    Shell shell_;
    int frame_ = 0;
};

/// What is accounted for of the light that meets the shell is 1, within three standard errors, which are at most `most_error`.
/// Returns the worst departure from 1.
double check_balance(bool absorbing, const Effort& effort, double most_error) {
    const AtmosphereParameters air = air_of(absorbing);
    Rgb total(0), squares(0), kept(0);
    for (int i = 0; i < effort.tries; ++i) {
        models::ReferenceSettings settings = paths(effort.paths, i + 1);
        settings.first_order_parts = effort.parts;
        Sky sky(cpu_double(), air, traced(settings));
        Accounts accounts(sky, air, effort, i);
        const Rgb absorbed = absorbing ? accounts.absorbed_by_ground() + accounts.absorbed_by_air() : Rgb(0);
        const Rgb all = accounts.straight() + accounts.out() + absorbed;
        total += all;
        squares += all * all;
        kept += absorbed;
    }
    const Rgb mean = total / static_cast<double>(effort.tries);
    const Rgb error = glm::sqrt((squares / static_cast<double>(effort.tries) - mean * mean) / (effort.tries - 1.0));
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
        std::printf("%s: %.5f +- %.5f of the light is accounted for (%.3f absorbed)\n",
                    absorbing ? "absorbing" : "conservative", mean[c], error[c], kept[c] / effort.tries);
        CHECK(std::abs(mean[c] - 1) < 3 * error[c]);
        CHECK(error[c] < most_error);
        worst = std::max(worst, std::abs(mean[c] - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("reference: what comes in goes out, from a planet that absorbs nothing") {
    check_balance(false, {.tries = 8, .places = 256, .directions = 16, .paths = 4, .parts = 2}, 0.0035);
}

TEST_CASE("reference: what comes in goes out or is absorbed by air and ground") {
    check_balance(true, {.tries = 8, .places = 128, .directions = 16, .paths = 2, .parts = 2}, 0.0018);
}

// Minutes, as all that is skipped: reference.md has the command and the figures.
TEST_CASE("reference: what comes in goes out, to 0.1 %" * doctest::skip()) {
    CHECK(check_balance(false, {.tries = 32, .places = 512, .directions = 64, .paths = 16, .parts = 4}, 3e-4) < 1e-3);
    CHECK(check_balance(true, {.tries = 16, .places = 256, .directions = 64, .paths = 4, .parts = 4}, 3e-4) < 1e-3);
}

namespace {

/// Lit evenly from all sides it has the light's own radiance everywhere.
void check_furnace(int count, double most_error) {
    const AtmosphereParameters air = air_of(false);
    std::vector<glm::dvec3> directions;
    const double zeniths[] = {0, 60, 85, 91, 120, 180};
    constexpr int azimuths = 4;
    for (const double zenith : zeniths)
        for (int k = 0; k < azimuths; ++k) directions.push_back(direction(zenith * degree, pi * (k + 0.5) / azimuths));
    TracedSky sky(air, paths(count));
    SkyOptions night = traced(paths(0));
    night.beyond = 1;
    Sky straight(cpu_double(), air, night);
    straight.place({0, 0, air.planet.bottom_radius_m + 5 * km}, {});
    std::vector<Rgb> seen(std::size(zeniths)), variance(std::size(zeniths), Rgb(0));
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = straight.radiance(directions[i * azimuths]);
    std::uint64_t frame = 0;
    for (const auto& [a, b] : {std::pair(-0.5, -0.2), {-0.2, -0.05}, {-0.05, 0.1}, {0.1, 1.0}})
        for (const Node& node : gauss_nodes(a, b)) {
            sky.frame(++frame);  // other paths for every sun, so that their errors are independent
            sky.stand(5 * km, sun_at(std::acos(node.at)));
            const auto [radiance, error] = sky.look(directions);
            const double weight = node.weight * 2 * pi / azimuths;
            for (std::size_t i = 0; i < directions.size(); ++i) {
                seen[i / azimuths] += weight * radiance[i];
                variance[i / azimuths] += weight * weight * error[i] * error[i];
            }
        }
    Scores scores;
    double greatest = 0, sum_seen = 0, sum_variance = 0;
    const double values = 3.0 * static_cast<double>(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            greatest = std::max(greatest, std::sqrt(variance[i][c]));
            sum_seen += seen[i][c] / values;
            sum_variance += variance[i][c] / values;
            scores.add(seen[i][c] - 1, std::hypot(std::sqrt(variance[i][c]), 2e-4), zeniths[i], c, seen[i][c]);
        }
    scores.check("white furnace", 18);
    std::printf("    mean %.5f; standard error of a value: %.5f at most, %.5f rms\n", sum_seen, greatest,
                std::sqrt(sum_variance));
    CHECK(greatest < most_error);
}

}  // namespace

TEST_CASE("reference: in uniform light a planet that absorbs nothing cannot be seen") { check_furnace(64, 0.022); }

TEST_CASE("reference: in uniform light a planet that absorbs nothing cannot be seen, in many paths" * doctest::skip()) {
    check_furnace(1024, 6e-3);
}
