// The path tracer where the planet is so wide that it is flat: against discrete ordinates, and against Chandrasekhar's tables.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/traced.h"
#include "physics/truth.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double radius = 6e9, thickness = 1000;  // m

AtmosphereParameters layer(double optical_depth, double albedo, const PhaseFunction& phase, double ground_albedo) {
    AtmosphereParameters air;
    air.planet.bottom_radius_m = radius;
    air.planet.top_radius_m = radius + thickness;
    air.planet.ground_albedo = Rgb(ground_albedo);
    const double extinction = optical_depth / thickness;
    air.terms = {even_term(Rgb(albedo * extinction), Rgb((1 - albedo) * extinction), phase)};
    return air;
}

using Rows = std::vector<std::map<std::string, std::string>>;

PhaseFunction phase_of(const std::map<std::string, std::string>& row) {
    if (row.at("phase") == "rayleigh") return RayleighPhase{};
    return HenyeyGreensteinPhase{number(row, "g")};
}

/// Every so many rows of a case.
void add_case(Scores& scores, const Rows& rows, std::size_t every, int seed) {
    TracedSky sky(layer(number(rows[0], "optical_depth"), number(rows[0], "single_scattering_albedo"), phase_of(rows[0]), 0),
                  paths(2048, seed));
    for (const bool top : {false, true}) {
        sky.stand(top ? thickness : 0, sun_at(std::acos(number(rows[0], "sun_mu"))));
        std::vector<glm::dvec3> directions;
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < rows.size(); i += every) {
            if ((rows[i].at("level") == "top") != top) continue;
            const double zenith = std::acos(number(rows[i], "view_mu"));
            directions.push_back(direction(top ? pi - zenith : zenith, number(rows[i], "azimuth_deg") * degree));
            chosen.push_back(i);
        }
        const auto [radiance, error] = sky.look(directions);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const double truth = number(rows[chosen[i]], "radiance_per_sr");
            // Nothing here depends on the channel. The table has nine digits.
            scores.add(radiance[i].g - truth, std::hypot(error[i].g, 1e-8 * truth), rows[0].at("case"), chosen[i],
                       radiance[i].g, truth, error[i].g);
            CHECK(error[i].g < 0.1 * truth);
        }
    }
}

/// Chandrasekhar's H for isotropic scattering without absorption, by its equation 1 / H(mu) = 1/2 int_0^1 m H(m) / (mu + m) dm.
class HFunction {
public:
    HFunction() : nodes_(gauss_nodes(0, 0.05)) {
        for (const auto& [from, to] : {std::pair(0.05, 0.3), std::pair(0.3, 1.0)})
            for (const Node& node : gauss_nodes(from, to)) nodes_.push_back(node);
        values_.assign(nodes_.size(), 2);
        for (int round = 0; round < 100; ++round) {
            std::vector<double> next;
            for (std::size_t i = 0; i < nodes_.size(); ++i) next.push_back(std::sqrt(values_[i] * (*this)(nodes_[i].at)));
            values_ = next;
        }
    }
    [[nodiscard]] double operator()(double mu) const {
        double sum = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            sum += nodes_[i].weight * nodes_[i].at * values_[i] / (mu + nodes_[i].at);
        return 2 / sum;
    }

private:
    std::vector<Node> nodes_;
    std::vector<double> values_;
};

/// Chandrasekhar, Radiative Transfer (1950; Dover 1960), table XI, single scattering albedo 1: mu = 0.1, 0.2, ... 1.
constexpr std::array<double, 10> table_xi{1.2474, 1.4503, 1.6425, 1.8293, 2.0128, 2.1941, 2.3740, 2.5527, 2.7306, 2.9078};

}  // namespace

TEST_CASE("reference: a flat layer, against discrete ordinates") {
    std::map<std::string, Rows> cases;
    const TruthTable table = read_truth("plane_parallel.csv");
    for (const auto& row : table.rows) cases[row.at("case")].push_back(row);
    REQUIRE(cases.size() == 8);
    Scores scores;
    int seed = 0;
    for (const auto& [name, rows] : cases) add_case(scores, rows, rows.size() > 20 ? 7 : 3, ++seed);
    scores.check("flat layers", 75);
}

TEST_CASE("reference: a thick layer that absorbs nothing reflects as Chandrasekhar's table XI says") {
    const HFunction h;
    for (std::size_t i = 0; i < table_xi.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(h(0.1 * static_cast<double>(i + 1)) - table_xi[i]) < 1e-4);
    }
    // Over white ground, which returns all that comes through, a layer of optical depth 10 is as good as one without end: no
    // flux passes through either, and deep inside both are evenly lit.
    TracedSky sky(layer(10, 1, HenyeyGreensteinPhase{0}, 1), paths(4096));
    Scores scores;
    double noise = 0;
    std::uint64_t frame = 0;
    for (const int sun : {3, 8}) {
        sky.frame(++frame);
        const double mu_0 = 0.1 * sun;
        sky.stand(thickness, sun_at(std::acos(mu_0)));
        std::vector<glm::dvec3> directions;
        for (const int view : {1, 3, 6, 10}) directions.push_back(direction(pi - std::acos(0.1 * view), 0.7 * view));
        const auto [radiance, error] = sky.look(directions);
        std::size_t i = 0;
        for (const int view : {1, 3, 6, 10}) {
            const double mu = 0.1 * view;
            const auto at = [](int tenth) { return table_xi[static_cast<std::size_t>(tenth - 1)]; };
            // I = F / 4 mu_0 / (mu + mu_0) H(mu) H(mu_0), where pi F = 1 is the irradiance of a surface that faces the sun.
            const double reflected = mu_0 / (mu + mu_0) * at(view) * at(sun) / (4 * pi);
            scores.add(radiance[i].g - reflected, error[i].g, mu_0, mu, radiance[i].g, reflected, error[i].g);
            noise += error[i].g / reflected / 8;
            ++i;
        }
    }
    std::printf("H functions: mean standard error %.2f %%\n", 100 * noise);
    CHECK(noise < 0.03);
    scores.check("diffuse reflection by H", 8);
}
