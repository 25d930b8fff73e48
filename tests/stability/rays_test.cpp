// Rays of a camera and the light that they gather: where they start and end, single scattering, the sun's share.
#include "stability/formulas.h"
#include "stability/worst.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

using namespace aureole;
using namespace aureole::stability;

namespace {

/// Of what kernels are given, in whichever precision they compute.
constexpr double step = static_cast<double>(std::numeric_limits<float>::epsilon());

bool within(double x, double low, double high) { return x >= low && x <= high; }
template <class Vec>
bool each_within(const Vec& v, double low, double high) {
    return within(v.x, low, high) && within(v.y, low, high) && within(v.z, low, high);
}

/// The directions of which it is one are floats.
bool is_cosine(double x) { return within(x, -1 - 4 * step, 1 + 4 * step); }

template <class real>
using Kernel = kernels::StabilityFormulas<real>;
template <class real>
using Ray = typename Kernel<real>::Ray;

template <class real>
glm::vec<3, real> direction_of(const Case& c, double zenith, double azimuth) {
    return glm::vec<3, real>(glm::vec3(c.world(zenith, azimuth)));
}

/// The camera's ray in a direction as the table of the sky has it, by the direction's own parts.
template <class real>
Ray<real> table_ray(Kernel<real>& k, const glm::vec<3, real>& direction) {
    const auto v = k.view_direction(direction);
    return k.camera_ray_towards(v.mu, v.sine, glm::dot(v.horizontal, glm::vec<3, real>(k.view.sun_azimuth[0])), 0);
}
/// The same as pixels of geometry have it.
template <class real>
Ray<real> pixel_ray(Kernel<real>& k, const glm::vec<3, real>& direction) {
    const auto v = k.view_direction(direction);
    return k.camera_air_ray(v, k.distance_to_air(v), 0, glm::dot(direction, glm::vec<3, real>(k.view.sun_direction[0])));
}

template <class real>
bool sound(Kernel<real>& k, const Ray<real>& ray) {
    const double longest = 2.01 * static_cast<double>(k.bottom_radius() + k.shell_thickness());
    return within(ray.altitude, 0, static_cast<double>(k.shell_thickness())) && is_cosine(ray.mu) && is_cosine(ray.mu_s) &&
           is_cosine(ray.nu) && within(ray.end, 0, longest);
}

template <class real>
void check_rays(Ledger& ledger, const Case& c, Kernel<real>& k, const glm::vec<3, real>& direction) {
    const auto v = k.view_direction(direction);
    ledger.check("a direction's parts are in range", c, is_cosine(v.mu) && is_cosine(v.sine) && v.sine >= 0);
    ledger.check("distance to the air is -1, 0 or more", c,
                 k.distance_to_air(v) == -1 || within(k.distance_to_air(v), 0, 1e30));
    ledger.check("a ray of the table is sound", c, sound(k, table_ray(k, direction)));
    ledger.check("a ray of a pixel is sound", c, sound(k, pixel_ray(k, direction)));
    const real half_sine = k.sky_view_half_sine(static_cast<real>(c.random(700)), c.random(701) < 0.5);
    ledger.check("half a sine is one", c, within(half_sine, 0, 1));
    const real cosine = k.sky_view_azimuth_cosine(static_cast<real>(c.random(702)));
    ledger.check("rows and columns of the sky's table are sound rays", c,
                 sound(k, k.camera_ray(half_sine, c.random(701) < 0.5, cosine, 0)));
    ledger.check("chord to the horizon is one", c, within(k.chord_to_horizon(v.mu, v.sine), 0, 2 + 8 * step));
}

/// Orders of nothing but the sun's own beam: no more than what the ray takes out of it.
template <class real>
void check_light(Ledger& ledger, const Case& c, Kernel<real>& k, const Ray<real>& ray) {
    const auto light = k.march(ray);
    ledger.check("optical depth of what is marched is finite and not negative", c, each_within(light.depth, 0, 1e30));
    glm::vec<3, real> caught(0);
    for (int i = 0; i < k.PHASE_COUNT; ++i) {
        ledger.check("single scattering is finite and not negative", c, each_within(light.single[i], 0, 1e30));
        caught += light.single[i];
    }
    for (int i = 0; i < 3; ++i)
        ledger.add("no more is scattered once than is taken", c,
                   static_cast<double>(caught[i]) / (-std::expm1(-static_cast<double>(light.depth[i])) * (1 + 1e-5) + 1e-30));
    ledger.check("no light is gathered without a sun's irradiance", c, light.multiple == glm::vec<3, real>(0));
    const auto ground = k.ground_radiance(light.depth, k.ground_beam_irradiance(ray.mu_s));
    ledger.check("radiance of the ground is in [0, 1 / pi]", c, each_within(ground, 0, 0.318310));
}

template <class real>
void check_sun(Ledger& ledger, const Case& c, Kernel<real>& k) {
    const real mu = k.view.sun_direction[0].w, sine = k.view.sun_azimuth[0].w, chord2 = k.view.sun_limb[0].w;
    const real h = k.view.space.x;
    const auto share = k.sun_share(h, mu, sine, chord2);
    ledger.check("share of the sun is in [0, 1]", c, each_within(share, 0, 1));
    ledger.check("share of a disk is in [0, 1]", c, within(k.visible_share(static_cast<real>(4 * c.random(710) - 2)), 0, 1));
    const double zenith = c.sun_zenith(), higher = std::max(zenith - 1e-3, 0.0);
    const auto raised = k.sun_share(h, static_cast<real>(std::cos(higher)), static_cast<real>(std::sin(higher)), chord2);
    // The disk comes up before its air thins: only beams through the same air, or none, can be told apart by height alone.
    if (k.TERM_COUNT == 0 && k.SUN_COUNT > 0)
        ledger.check("the higher the sun, the more of it is seen", c,
                     static_cast<double>(raised.x) >= static_cast<double>(share.x) - 16 * step);
}

template <class real>
void check_mirrored(Ledger& ledger, const Case& c, Kernel<real>& k) {
    const double zenith = c.view_zenith(), apart = c.sun_azimuth();
    // The mirror image of the view at azimuth 0 is at twice the sun's azimuth.
    const auto one = table_ray(k, direction_of<real>(c, zenith, 0));
    const auto other = table_ray(k, direction_of<real>(c, zenith, 2 * apart));
    const double across = std::sin(zenith) * std::sin(c.sun_zenith());
    // Rays are given by the angle from the horizon: of one near the zenith, seen from where the horizon is almost at the nadir,
    // its half has a cosine of a tenth with as many digits fewer (case 941214 of a million: 1.2e-6).
    ledger.add("left and right of the sun: angle", c,
               std::abs(static_cast<double>(one.nu - other.nu)) / (1.5e-6 * (1 + std::abs(across))));
}

/// A direction on either side of another, and cameras on either side of the top of the air: small steps of what a ray is.
template <class real>
void check_neighbours(Ledger& ledger, const Case& c, Kernel<real>& k) {
    const double zenith = std::clamp(c.view_zenith(), 1e-3, 3.14);
    const auto a = k.view_direction(direction_of<real>(c, zenith - 1e-6, 0)),
               b = k.view_direction(direction_of<real>(c, zenith + 1e-6, 0));
    ledger.check("a step of direction is a step of its chord to the horizon", c,
                 std::abs(static_cast<double>(k.chord_to_horizon(a.mu, a.sine) - k.chord_to_horizon(b.mu, b.sine))) <= 4e-6);
    if (k.chord_to_horizon(a.mu, a.sine) < 1)
        ledger.check("a step downwards is one towards the ground", c,
                     k.sine_above_horizon(a) >= k.sine_above_horizon(b) - real(4 * step));
}

template <class real>
void check_case(Ledger& ledger, const Case& c, Formulas<real>& formulas) {
    auto& kernel = formulas.set(Inputs(c));
    const auto direction = direction_of<real>(c, c.view_zenith(), 0);
    check_rays(ledger, c, kernel, direction);
    check_light(ledger, c, kernel, table_ray(kernel, direction));
    check_light(ledger, c, kernel, pixel_ray(kernel, direction));
    check_sun(ledger, c, kernel);
    check_mirrored(ledger, c, kernel);
    check_neighbours(ledger, c, kernel);
}

/// Of a million: straight down to a millionth, where the azimuth was taken for that of any direction (mended in view_ray.glsl);
/// and the one that is nearest to its bound.
constexpr std::array worst_cases{793948, 960724, 941214};

}  // namespace

TEST_CASE_TEMPLATE("stability, rays: sound, and no more light than there is", real, float, double) {
    Ledger ledger(sizeof(real) == 4 ? "rays in float" : "rays in double");
    const Range range = cases(3000);
    Formulas<real> formulas;
    for (std::uint64_t i = range.begin; i < range.end; ++i) check_case(ledger, Case(i), formulas);
    for (const int i : worst_cases) check_case(ledger, Case(static_cast<std::uint64_t>(i)), formulas);
    ledger.verify();
}
