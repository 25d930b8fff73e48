// The fitted wavelengths under skies that they were not made from: single scattering integrated through a spherical shell.
#include "spectrum/relative.h"
#include "spectrum/sky_spectra.h"

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::spectrum;
using namespace aureole::spectrum::detail;

namespace {

constexpr double ground = 6360e3, top = 6460e3;

/// Shares of their columns that molecules, aerosol and ozone have in a metre: x, y, z.
glm::dvec3 share_per_m(double altitude) {
    return {std::exp(-altitude / 8449) / 8449, std::exp(-altitude / 1200) / 1200,
            std::max(0.0, 1 - std::abs(altitude - 25e3) / 15e3) / 15e3};
}

/// Columns from a point to the top. False: the ground is in the way.
bool columns_to_top(const glm::dvec3& from, const glm::dvec3& direction, glm::dvec3& columns) {
    const double b = glm::dot(from, direction), c = glm::dot(from, from);
    if (b < 0 && b * b > c - ground * ground) return false;
    const double length = std::sqrt(b * b - c + top * top) - b;
    constexpr int steps = 80;
    columns = glm::dvec3(0);
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 at = from + direction * (length * (i + 0.5) / steps);
        columns += length / steps * share_per_m(glm::length(at) - ground);
    }
    return true;
}

/// A direction by elevation and azimuth in radians; z is up.
glm::dvec3 towards(double elevation, double azimuth) {
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// What a line of sight sees, per unit of solar irradiance.
struct Ray {
    struct Event {
        glm::dvec3 columns;         ///< From the sun to here and on to the eye.
        double molecules, aerosol;  ///< Shares of the columns that scatter here.
    };
    std::vector<Event> events;
    double molecular_phase, aerosol_phase, beta, alpha, dobson;

    double operator()(double nm) const {
        const glm::dvec3 depth(8449 * rayleigh_scattering(nm), angstrom_optical_depth(nm, beta, alpha),
                               dobson * 2.6867e20 * ozone_cross_section(nm));
        double sum = 0;
        for (const Event& e : events)
            sum += (molecular_phase * depth.x * e.molecules + 0.9 * aerosol_phase * depth.y * e.aerosol) *
                   std::exp(-glm::dot(depth, e.columns));
        return sum;
    }
};

Ray ray(unsigned i) {
    const auto point = [i](unsigned base) { return van_der_corput(i + 1, base); };
    // Half of the suns within -6 to 10 degrees.
    const double sun_elevation = -6 + (i % 2 == 0 ? 16 : 96) * point(3);
    const glm::dvec3 sun = towards(glm::radians(sun_elevation), 0);
    const glm::dvec3 view = towards(glm::radians(0.3 + 89 * point(5) * point(5)), 2 * glm::pi<double>() * point(7));
    const double cos_theta = glm::dot(sun, view), g = 0.76;
    Ray result{.events = {},
               .molecular_phase = 0.75 * (1 + cos_theta * cos_theta),
               .aerosol_phase = (1 - g * g) / std::pow(1 + g * g - 2 * g * cos_theta, 1.5),
               .beta = 0.15 * point(11) * point(11),
               .alpha = 1.5 * point(13),
               .dobson = 250 + 150 * point(17)};

    const glm::dvec3 eye(0, 0, ground + 2);
    const double length = std::sqrt(eye.z * view.z * eye.z * view.z - eye.z * eye.z + top * top) - eye.z * view.z;
    glm::dvec3 to_eye(0);
    constexpr int steps = 120;
    for (int k = 0; k < steps; ++k) {  // shorter steps near the eye
        const double from = length * k * k / (steps * steps), to = length * (k + 1) * (k + 1) / (steps * steps);
        const glm::dvec3 at = eye + view * (0.5 * (from + to));
        const glm::dvec3 passed = (to - from) * share_per_m(glm::length(at) - ground);
        glm::dvec3 to_sun;
        if (columns_to_top(at, sun, to_sun)) result.events.push_back({to_eye + 0.5 * passed + to_sun, passed.x, passed.y});
        to_eye += passed;
    }
    return result;
}

Spread judge_skies(const Wavelengths& wavelengths) {
    const Wavelengths forty = equal_bins(40);
    const auto colour = [](const Ray& sky, const Wavelengths& set) {
        Rgb sum(0);
        for (std::size_t i = 0; i < set.nm.size(); ++i) sum += set.to_rec709[i] * sky(set.nm[i]);
        return sum;
    };
    std::vector<double> differences;
    for (unsigned i = 0; i < 400; ++i) {
        const Ray sky = ray(i);
        const Rgb truth = colour(sky, forty);
        if (xyz_from_rec709(truth).y > 0.1) differences.push_back(difference(truth, colour(sky, wavelengths)));  // else: night
    }
    CHECK(differences.size() > 300);
    return spread(differences);
}

/// Within a tenth of the figures of spectrum.md.
void check_skies(int n, const Spread& stated) {
    const Spread actual = judge_skies(fitted(n));
    INFO(n << ": median " << actual.median << ", p95 " << actual.p95 << ", worst " << actual.worst);
    CHECK(relative(actual.median, stated.median) < 0.1);
    CHECK(relative(actual.p95, stated.p95) < 0.1);
    CHECK(relative(actual.worst, stated.worst) < 0.1);
}

}  // namespace

TEST_CASE("spectrum: the fitted wavelengths hold under skies of a spherical shell") {
    check_skies(3, {0.77, 1.6, 5.4});
    check_skies(4, {0.18, 0.44, 1.4});
    check_skies(6, {0.026, 0.06, 0.16});
}
