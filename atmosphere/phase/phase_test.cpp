#include "common/check.h"
#include "common/formulas.h"
#include "common/rejects.h"
#include "phase/distinct.h"
#include "quadrature/gauss_legendre.h"

#include <aureole/parameters.h>

#include <doctest/doctest.h>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace aureole;
using detail::rejected_field;

namespace {

constexpr double pi = std::numbers::pi;
const std::vector<double> asymmetries{-0.999, -0.9, -0.5, 0, 0.3, 0.76, 0.8, 0.95, 0.99, 0.999};

/// The kernels' formulas in either precision, without any air.
template <class real>
struct Formulas {
    std::array<rhi::CpuBinding, 3> bindings{};
    rhi::CpuArguments arguments{.specialization = {}, .bindings = bindings, .push_constants = {}};
    kernels::AirFormulas<real> kernel{arguments};

    real value(int kind, const glm::dvec4& parameters, double nu) {
        return kernel.phase_function(kind, glm::vec<4, real>(parameters), static_cast<real>(nu));
    }
};

/// Cosines, dense at both ends, that float holds exactly.
std::vector<double> cosines() {
    std::vector<double> result;
    for (int i = -20; i <= 20; ++i) result.push_back(static_cast<float>(i / 20.0));
    for (const double from_end : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        result.push_back(static_cast<float>(1 - from_end));
        result.push_back(static_cast<float>(from_end - 1));
    }
    return result;
}

}  // namespace

TEST_CASE("phase: known values") {
    CHECK(evaluate(RayleighPhase{}, 1) == doctest::Approx(3 / (8 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(RayleighPhase{}, 0) == doctest::Approx(3 / (16 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(HenyeyGreensteinPhase{0}, 0.3) == doctest::Approx(1 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    // g = 1/2: forward (3/4) / (1/2)^3, sideways (3/4) / (5/4)^1.5, backward (3/4) / (3/2)^3, each over 4 pi.
    CHECK(evaluate(HenyeyGreensteinPhase{0.5}, 1) == doctest::Approx(6 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(HenyeyGreensteinPhase{0.5}, 0) ==
          doctest::Approx(0.75 / std::pow(1.25, 1.5) / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(HenyeyGreensteinPhase{0.5}, -1) == doctest::Approx(0.75 / 3.375 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    // Cornette-Shanks: times 3/2 (1 + nu^2) / (9/4).
    CHECK(evaluate(CornetteShanksPhase{0.5}, 1) == doctest::Approx(8 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(CornetteShanksPhase{0.5}, 0) ==
          doctest::Approx(0.5 / std::pow(1.25, 1.5) / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(CornetteShanksPhase{0}, 0.7) ==
          doctest::Approx(evaluate(RayleighPhase{}, 0.7)).scale(1e-300).epsilon(1e-14));
    // The mixture at its ends, and half way: Draine with alpha = 0 is Henyey-Greenstein, with alpha = 1 Cornette-Shanks.
    CHECK(evaluate(HenyeyGreensteinDrainePhase{0.5, 0.3, 7, 0}, 1) ==
          doctest::Approx(6 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(HenyeyGreensteinDrainePhase{0.3, 0.5, 0, 1}, 1) ==
          doctest::Approx(6 / (4 * pi)).scale(1e-300).epsilon(1e-14));
    CHECK(evaluate(HenyeyGreensteinDrainePhase{0.5, 0.5, 1, 0.5}, 1) ==
          doctest::Approx(7 / (4 * pi)).scale(1e-300).epsilon(1e-14));
}

TEST_CASE("phase: forward and backward lobes mirror each other") {
    for (const double g : {0.3, 0.9, 0.999})
        for (const double nu : cosines())
            CHECK(evaluate(HenyeyGreensteinPhase{g}, nu) == evaluate(HenyeyGreensteinPhase{-g}, -nu));
}

TEST_CASE("phase: Henyey-Greenstein's moments are the powers of g") {
    for (const double g : asymmetries) {
        CAPTURE(g);
        const std::vector<double> p = legendre_moments(HenyeyGreensteinPhase{g}, 32);
        REQUIRE(p.size() == 32);
        for (int l = 0; l < 32; ++l) {
            CAPTURE(l);
            CHECK(std::abs(p[static_cast<std::size_t>(l)] - std::pow(g, l)) < 1e-9);
        }
    }
    // High orders too, where P_l swings a hundred times.
    const std::vector<double> many = legendre_moments(HenyeyGreensteinPhase{0.99}, 256);
    CHECK(many[255] == doctest::Approx(std::pow(0.99, 255)).scale(1e-300).epsilon(1e-8));
}

TEST_CASE("phase: Rayleigh has p_0 = 1, p_2 = 1/10 and nothing else") {
    const std::vector<double> p = legendre_moments(RayleighPhase{}, 12);
    for (std::size_t l = 0; l < 12; ++l) CHECK(std::abs(p[l] - (l == 0 ? 1.0 : l == 2 ? 0.1 : 0.0)) < 1e-13);
}

TEST_CASE("phase: Cornette-Shanks integrates to 1 and has its mean cosine") {
    for (const double g : asymmetries) {
        CAPTURE(g);
        const std::vector<double> p = legendre_moments(CornetteShanksPhase{g}, 2);
        CHECK(p[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-9));
        CHECK(std::abs(p[1] - 3 * g * (4 + g * g) / (5 * (2 + g * g))) < 1e-9);
    }
}

TEST_CASE("phase: HG + Draine integrates to 1 and has its mean cosine") {
    for (const double g : asymmetries)
        for (const double alpha : {0.0, 1.0, 20.0, 1e4})
            for (const double w : {0.0, 0.4, 1.0}) {
                CAPTURE(g);
                CAPTURE(alpha);
                CAPTURE(w);
                const std::vector<double> p = legendre_moments(HenyeyGreensteinDrainePhase{0.9, g, alpha, w}, 2);
                const double draine = (g + alpha * (3 * g + 2 * g * g * g) / 5) / (1 + alpha * (1 + 2 * g * g) / 3);
                CHECK(p[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-9));
                CHECK(std::abs(p[1] - ((1 - w) * 0.9 + w * draine)) < 1e-9);
            }
}

TEST_CASE("phase: the droplet fit of Jendersie & d'Eon") {
    // Worked out by hand for 10 um: exponents -0.0990567/8.32846, -2.20679/13.91029 - 0.428934, 3.62489 - 8.29288/15.52825,
    // -0.599085/9.358417 - 0.665888.
    const auto p = HenyeyGreensteinDrainePhase::from_droplet_diameter(10);
    CHECK(p.g_hg == doctest::Approx(0.9881767).scale(1e-300).epsilon(1e-6));
    CHECK(p.g_draine == doctest::Approx(0.5556713).scale(1e-300).epsilon(1e-6));
    CHECK(p.alpha == doctest::Approx(21.995521).scale(1e-300).epsilon(1e-6));
    CHECK(p.weight == doctest::Approx(0.4819554).scale(1e-300).epsilon(1e-6));
    for (const double d : {5.0, 12.0, 50.0}) {
        const PhaseFunction fit = HenyeyGreensteinDrainePhase::from_droplet_diameter(d);
        CHECK(legendre_moments(fit, 1)[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-9));
    }
    for (const double d : {4.9, 50.1, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        CHECK(rejected_field([&] { (void)HenyeyGreensteinDrainePhase::from_droplet_diameter(d); }) == "diameter_um");
}

TEST_CASE("phase: float agrees with double, up to |g| = 0.999 and into the peak") {
    Formulas<float> single;
    Formulas<double> exact;
    using Kernel = kernels::AirFormulas<double>;
    double worst = 0;
    for (const double g : asymmetries) {
        const double g_float =
            static_cast<float>(g);  // parameters travel in float: the formula is judged, not the rounding of g
        for (const double nu : cosines()) {
            for (const int kind : {Kernel::PHASE_RAYLEIGH, Kernel::PHASE_HENYEY_GREENSTEIN, Kernel::PHASE_CORNETTE_SHANKS,
                                   Kernel::PHASE_HG_DRAINE}) {
                const glm::dvec4 parameters(g_float, static_cast<float>(0.9 * g), 20, 0.25);
                const double reference = exact.value(kind, parameters, nu);
                worst = std::max(worst, std::abs(single.value(kind, parameters, nu) - reference) / reference);
            }
        }
    }
    CHECK(worst < 1e-6);
}

TEST_CASE("phase: a table follows its function, at any scale") {
    for (const double scale : {1.0, 1e-40, 1e40}) {
        TabulatedPhase table;
        const CornetteShanksPhase truth{0.76};
        for (int i = 0; i <= 3600; ++i) {
            table.angle_rad.push_back(pi * i / 3600);
            table.value.push_back(scale * evaluate(truth, std::cos(table.angle_rad.back())));
        }
        for (int degrees = 0; degrees <= 180; degrees += 15) {
            CAPTURE(degrees);
            const double nu = std::cos(degrees * pi / 180);
            CHECK(evaluate(table, nu) == doctest::Approx(evaluate(truth, nu)).scale(1e-300).epsilon(1e-4));
        }
        const std::vector<double> p = legendre_moments(table, 8), q = legendre_moments(truth, 8);
        CHECK(p[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-12));
        for (std::size_t l = 0; l < 8; ++l) CHECK(p[l] == doctest::Approx(q[l]).scale(1e-300).epsilon(2e-5));
    }
}

TEST_CASE("phase: a table is linear in theta between its samples, and normalized") {
    // Value 1 - theta / pi: over the sphere 2 pi integral (1 - theta/pi) sin(theta) = 2 pi.
    const TabulatedPhase ramp{{0, pi}, {1, 0}};
    CHECK(evaluate(ramp, 1) == doctest::Approx(1 / (2 * pi)).scale(1e-300).epsilon(1e-3));  // a mean over the first texel's hat
    CHECK(evaluate(ramp, 0) == doctest::Approx(0.5 / (2 * pi)).scale(1e-300).epsilon(1e-6));
    CHECK(evaluate(ramp, std::cos(1.0)) == doctest::Approx((1 - 1 / pi) / (2 * pi)).scale(1e-300).epsilon(1e-6));
    CHECK(legendre_moments(ramp, 1)[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-12));
    // A peak far thinner than a texel keeps its share: over a uniform background that sums to 4 pi, a cone of height P within
    // 1e-4 rad adds 2 pi P 1e-8 / 6. With that 4 pi as well, half the light goes straight on.
    const TabulatedPhase forward{{0, 1e-4, pi}, {1 + 12e8, 1, 1}};
    const std::vector<double> p = legendre_moments(forward, 2);
    CHECK(p[0] == doctest::Approx(1).scale(1e-300).epsilon(1e-7));
    CHECK(p[1] == doctest::Approx(0.5).scale(1e-300).epsilon(1e-5));
}

TEST_CASE("phase: what evaluate and legendre_moments reject") {
    CHECK(rejected_field([] { (void)evaluate(RayleighPhase{}, 1.0001); }) == "cos_theta");
    CHECK(rejected_field([] { (void)evaluate(RayleighPhase{}, std::numeric_limits<double>::quiet_NaN()); }) == "cos_theta");
    CHECK(rejected_field([] { (void)evaluate(HenyeyGreensteinPhase{1}, 0); }) == "phase.g");
    CHECK(rejected_field([] { (void)legendre_moments(CornetteShanksPhase{-1}, 3); }) == "phase.g");
    CHECK(rejected_field([] { (void)legendre_moments(RayleighPhase{}, 0); }) == "count");
    CHECK(rejected_field([] { (void)legendre_moments(RayleighPhase{}, 257); }) == "count");
}

TEST_CASE("distinct_phases: equal ones once, Rayleigh first, only of terms that scatter") {
    const auto term = [](const PhaseFunction& phase, double scattering) {
        return DensityTerm{.name = "",
                           .profile = ExponentialProfile{},
                           .scattering_per_m = Rgb(scattering),
                           .absorption_per_m = Rgb(1e-6),
                           .phase = phase};
    };
    const std::vector<PhaseFunction> phases = detail::distinct_phases(
        {term(HenyeyGreensteinPhase{0.5}, 1), term(CornetteShanksPhase{0.5}, 0), term(RayleighPhase{}, 1),
         term(HenyeyGreensteinPhase{0.5}, 2), term(HenyeyGreensteinPhase{0.6}, 1)});
    REQUIRE(phases.size() == 3);
    CHECK(phases[0] == PhaseFunction(RayleighPhase{}));
    CHECK(phases[1] == PhaseFunction(HenyeyGreensteinPhase{0.5}));
    CHECK(phases[2] == PhaseFunction(HenyeyGreensteinPhase{0.6}));
    CHECK(detail::phase_index(phases, HenyeyGreensteinPhase{0.6}) == 2);
}
