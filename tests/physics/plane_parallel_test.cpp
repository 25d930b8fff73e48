// All orders of scattering in one flat homogeneous layer, against discrete ordinates (48 streams): another method altogether.
#include <doctest/doctest.h>

#include "physics/sky.h"
#include "physics/truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

using namespace aureole;
using namespace aureole::physics;

namespace {

constexpr double thickness = 1000;  // m

/// The layer on a planet so large that it is flat.
AtmosphereParameters layer(double optical_depth, double albedo, const PhaseFunction& phase) {
    AtmosphereParameters parameters;
    parameters.planet.bottom_radius_m = 1e9;
    parameters.planet.top_radius_m = 1e9 + thickness;
    parameters.planet.ground_albedo = Rgb(0);
    const double extinction = optical_depth / thickness;
    parameters.terms = {even_term(Rgb(albedo * extinction), Rgb((1 - albedo) * extinction), phase)};
    return parameters;
}

QualitySettings of_order(int angular_order) {
    QualitySettings quality = fine();
    quality.angular_order = angular_order;
    quality.multi_scatter = {24, 10, 1};
    quality.multi_scatter_zenith = 8;
    quality.multi_scatter_azimuth = 6;
    quality.multi_scatter_nodes = 6;
    quality.multi_scatter_orders = 10;
    quality.sky_view = {48, 192, 1};
    return quality;
}

using Row = std::map<std::string, std::string>;

struct Errors {
    double median, worst;
};
Errors errors_of(const std::vector<Row>& rows, int angular_order) {
    const double optical_depth = number(rows[0], "optical_depth"), albedo = number(rows[0], "single_scattering_albedo");
    const PhaseFunction phase = rows[0].at("phase") == "rayleigh"
                                    ? PhaseFunction(RayleighPhase{})
                                    : PhaseFunction(HenyeyGreensteinPhase{number(rows[0], "g")});
    SkyOptions options;
    options.quality = of_order(angular_order);
    Sky sky(cpu_float(), layer(optical_depth, albedo, phase), options);
    std::vector<double> errors;
    for (const bool top : {false, true}) {
        sky.stand(top ? thickness : 0, sun_at(std::acos(number(rows[0], "sun_mu"))));
        std::vector<glm::dvec3> directions;
        std::vector<double> truth;
        for (const Row& row : rows) {
            if ((row.at("level") == "top") != top) continue;
            const double zenith = std::acos(number(row, "view_mu"));
            directions.push_back(direction(top ? pi - zenith : zenith, number(row, "azimuth_deg") * degree));
            truth.push_back(number(row, "radiance_per_sr"));
        }
        const std::vector<Rgb> seen = sky.radiance(directions);
        for (std::size_t i = 0; i < seen.size(); ++i) errors.push_back(std::abs(seen[i].g / truth[i] - 1));
    }
    std::ranges::sort(errors);
    return {errors[errors.size() / 2], errors.back()};
}

}  // namespace

TEST_CASE("a flat layer: every order of scattering, for each angular order L") {
    const auto file = truth_file("plane_parallel.csv");
    if (!file) return;
    std::map<std::string, std::vector<Row>> cases;
    for (const Row& row : read_truth(*file).rows) cases[row.at("case")].push_back(row);
    REQUIRE(cases.size() >= 8);

    std::printf("flat layer, median / worst error in %%\n%-20s %14s %14s %14s %14s\n", "", "L = 0", "L = 2", "L = 4", "L = 8");
    for (const auto& [name, rows] : cases) {
        CAPTURE(name);
        std::map<int, Errors> by_order;
        for (const int order : {0, 2, 4, 8}) by_order[order] = errors_of(rows, order);
        std::printf("%-20s", name.c_str());
        for (const auto& [order, e] : by_order) std::printf(" %6.2f / %5.2f", 100 * e.median, 100 * e.worst);
        std::printf("\n");
    }
}
