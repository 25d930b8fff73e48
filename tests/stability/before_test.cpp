// The air before geometry, by the kernel of the model `single`: what it adds and takes up to a distance.
#include "stability/inputs.h"
#include "stability/worst.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>

namespace aureole::kernels {
AUREOLE_DEFINE_CPU_KERNEL(AirBeforeFormulas)
#include "composite/inputs.glsl"

#include "models/single/nested.glsl"

#include "models/single/single_sky.glsl"
};
}  // namespace aureole::kernels

using namespace aureole;
using namespace aureole::stability;

namespace {

template <class real>
using Kernel = kernels::AirBeforeFormulas<real>;
template <class real>
using Air = Fed<kernels::AirBeforeFormulas, real>;
template <class real>
using Vec = glm::vec<3, real>;

/// By rules of 8, 12 and 16 nodes, for the view and for the light. Eight times their difference is more than the one of 8 is
/// off by wherever twice the nodes take an eighth off the error.
template <class real>
struct Rules {
    Rules() {
        for (auto* air : {&few, &more, &many}) {
            const int nodes = air == &few ? 8 : air == &more ? 12 : 16;
            air->kernel.LIGHT_NODES = nodes;
            Air<real>::rule(air->kernel.light_quadrature, nodes);
        }
    }
    void set(const Inputs& in) {
        for (auto* air : {&few, &more, &many}) air->set(in);
    }
    Air<real> few{8}, more{12}, many{16};
};

struct Seen {
    glm::dvec3 radiance, transmittance;
};
template <class real>
Seen before(Kernel<real>& k, real distance_km, const Vec<real>& direction) {
    const auto air = k.aerial_perspective(real(0), real(0), distance_km, direction);
    return {glm::dvec3(air.radiance), glm::dvec3(air.transmittance)};
}

/// The camera's ray in a direction: how far it goes in the air, and what its air would send at most.
template <class real>
struct Sight {
    Sight(Kernel<real>& k, const Case& c) : direction(glm::vec3(c.world(c.view_zenith(), 0))) {
        const auto v = k.view_direction(direction);
        const real entry = k.distance_to_air(v);
        sees_air = entry >= 0;
        nu = glm::dot(direction, Vec<real>(k.view.sun_direction[0]));
        ray = k.camera_air_ray(v, entry, 0, nu);
        for (int i = 0; i < k.PHASE_COUNT; ++i) brightest = std::max(brightest, static_cast<double>(k.phase_value(i, nu)));
    }
    Vec<real> direction;
    typename Kernel<real>::Ray ray;
    real nu = 0;
    bool sees_air = false;
    double brightest = 0;
};

double over(const glm::dvec3& is, const glm::dvec3& most) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        if (is[i] > 0) worst = std::max(worst, is[i] / std::max(most[i], 1e-30));
    return worst;
}
bool within(const glm::dvec3& v, double low, double high) {
    for (int i = 0; i < 3; ++i)
        if (!(v[i] >= low && v[i] <= high)) return false;
    return true;
}

template <class real>
void check_one(Ledger& ledger, const Case& c, Kernel<real>& k, const Sight<real>& sight, const Seen& seen) {
    const glm::dvec3 sun(k.view.sun_irradiance[0]);
    ledger.check("transmittance is in [0, 1]", c, within(seen.transmittance, 0, 1));
    ledger.check("light is finite and not negative", c, within(seen.radiance, 0, 1e30));
    // What is taken is scattered at most, into this direction by the largest of the phase functions.
    const glm::dvec3 taken = glm::dvec3(1) - seen.transmittance + 4 * static_cast<double>(std::numeric_limits<real>::epsilon());
    ledger.add("no more light is sent than is taken", c, over(seen.radiance, 1.00001 * sight.brightest * sun * taken));
}

/// By distance: from nothing at all up to all of the air, and on.
template <class real>
void check_growth(Ledger& ledger, const Case& c, Rules<real>& rules, const Sight<real>& sight) {
    auto& k = rules.few.kernel;
    const Seen none = before(k, real(0), sight.direction);
    ledger.check("no distance, no air", c, none.transmittance == glm::dvec3(1) && none.radiance == glm::dvec3(0));
    const glm::dvec3 sun(k.view.sun_irradiance[0]);
    const double rounding = 64 * static_cast<double>(std::numeric_limits<real>::epsilon());
    Seen last = none;
    glm::dvec3 open_before(0);
    for (const double share : {1e-9, 1e-6, 1e-3, 0.01, 0.1, 0.1001, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0}) {
        const real distance = sight.ray.end * static_cast<real>(share);
        const Seen now = before(k, distance, sight.direction), finer = before(rules.more.kernel, distance, sight.direction),
                   finest = before(rules.many.kernel, distance, sight.direction);
        check_one(ledger, c, k, sight, now);
        const glm::dvec3 open = glm::max(glm::abs(now.radiance - finest.radiance), glm::abs(finer.radiance - finest.radiance));

        const glm::dvec3 slack = 8.0 * (open + open_before) + rounding * (last.radiance + sight.brightest * sun);
        ledger.add("the farther, the more light", c, over(last.radiance - now.radiance, slack));
        last = now;
        open_before = open;
    }
}

/// A step across the end of the air, or across the ground, is a step in light.
template <class real>
void check_ends(Ledger& ledger, const Case& c, Kernel<real>& k, const Sight<real>& sight) {
    const real to_top = k.distance_to_top(sight.ray.altitude, sight.ray.mu);
    const Seen at = before(k, to_top, sight.direction), beyond = before(k, to_top * real(2) + real(1), sight.direction);
    ledger.check("behind the air there is no more of it", c,
                 at.radiance == beyond.radiance && at.transmittance == beyond.transmittance);
    check_one(ledger, c, k, sight, at);
    const Seen here = before(k, sight.ray.end, sight.direction);
    const auto light = k.march_single(sight.ray);
    const glm::dvec3 sun(k.view.sun_irradiance[0]), whole = sun * glm::dvec3(k.scattered_once(light, sight.nu));
    ledger.add("at the end of its ray stands the light of the sky", c,
               over(glm::abs(here.radiance - whole), 1e-4 * sight.brightest * sun));
    ledger.add("at the end of its ray stands what the sky lets through", c,
               over(glm::abs(here.transmittance - glm::exp(-glm::dvec3(light.depth))), glm::dvec3(1e-4)));
}

template <class real>
void check_all(Ledger& ledger, const Case& c, Rules<real>& rules) {
    if (c.suns().empty()) return;
    rules.set(Inputs(c));
    const Sight<real> sight(rules.few.kernel, c);
    if (!sight.sees_air) return;
    check_growth(ledger, c, rules, sight);
    check_ends(ledger, c, rules.few.kernel, sight);
}

template <class real>
const char* title() {
    return sizeof(real) == 4 ? "air before geometry in float" : "air before geometry in double";
}

/// Some of those of 100,000 in which light does not grow with distance (docs/stability.md), by so many times what is allowed.
struct Known {
    std::uint64_t index;
    double in_float, in_double;  ///< 0: holds.
};
constexpr Known all_known[] = {
    {16115, 7130, 10100},                          // a sheet of air that no node meets
    {16504, 0, 28700},                             // so, too
    {27843, 1490, 0},                              // this one and the next: above a planet of 10^12 m
    {34243, 62400, 17800000}, {47614, 0, 679000},  // level in a shell of 19 m, the sun on the horizon
};
template <class real>
double most_of(const Known& known) {
    return sizeof(real) == 4 ? known.in_float : known.in_double;
}
template <class real>
bool is_known(std::uint64_t index) {
    return std::ranges::any_of(all_known, [&](const Known& one) { return one.index == index && most_of<real>(one) > 0; });
}

}  // namespace

TEST_CASE_TEMPLATE("stability, air before geometry: light and transmittance of every distance", real, float, double) {
    Ledger ledger(title<real>());
    const Range range = cases(2000);
    Rules<real> rules;
    for (std::uint64_t i = range.begin; i < range.end; ++i)
        if (!is_known<real>(i)) check_all(ledger, Case(i), rules);
    ledger.verify();
}

TEST_CASE_TEMPLATE("stability, air before geometry: known to fail: light falls with distance", real, float, double) {
    Rules<real> rules;
    for (const Known& one : all_known) {
        if (most_of<real>(one) == 0) continue;
        Ledger ledger(title<real>());
        check_all(ledger, Case(one.index), rules);
        ledger.verify_known("the farther, the more light", 1.5 * most_of<real>(one));
    }
}
