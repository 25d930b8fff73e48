// The path tracer against closed forms, quadrature of the tests' own, and tables of truth.
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/traced.h"
#include "physics/truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;
using models::ReferenceSettings;

namespace {

struct Truth {
    Rgb all, error, first;
};
Truth truth_of(const std::map<std::string, std::string>& row) {
    constexpr const char* channels[] = {"r_per_sr", "g_per_sr", "b_per_sr"};
    Truth truth;
    for (int c = 0; c < 3; ++c) {
        const std::string channel = channels[c];
        truth.all[c] = number(row, "L_" + channel);
        truth.error[c] = number(row, "stderr_" + channel);
        truth.first[c] = number(row, "L1_" + channel) + number(row, "Lground1_" + channel);
    }
    return truth;
}

/// Every so many rows of a table, all orders and the first alone.
void check_truth(const char* file, const AtmosphereParameters& air, std::size_t every, double first_limit) {
    ReferenceSettings once = paths(0);
    once.max_order = 1;
    TracedSky sky(air, paths(1024));
    Sky first_sky(cpu_double(), air, traced(once));
    Scores scores;
    Worst first;
    double noise = 0;
    std::size_t rows = 0;
    const TruthTable table = read_truth(file);
    for (std::size_t i = 0; i < table.rows.size(); i += every) {
        const Truth truth = truth_of(table.rows[i]);
        // A row that is 0 says only that the sun is down, and one whose last digit shows has none of its standard error.
        if (!(sum(truth.error) > 0)) continue;
        const auto at = [&](const char* column) { return number(table.rows[i], column); };
        const Sun sun = sun_at(at("sun_zenith_deg") * degree);
        sky.frame(i);  // other paths for every row, so that their errors are independent
        sky.stand(at("altitude_km") * 1000, sun);
        first_sky.stand(at("altitude_km") * 1000, sun);
        const glm::dvec3 view = direction(at("view_zenith_deg") * degree, at("azimuth_deg") * degree);
        const auto [radiance, error] = sky.look(std::span(&view, 1));
        for (int c = 0; c < 3; ++c)
            if (truth.error[c] > 0)
                scores.add(radiance[0][c] - truth.all[c], std::hypot(error[0][c], truth.error[c]), i, c, radiance[0][c],
                           truth.all[c], error[0][c], truth.error[c]);
        if (sum(truth.first) > 1e-9)
            first.add(apart(first_sky.radiance(view), truth.first), i, at("sun_zenith_deg"), at("altitude_km"),
                      at("view_zenith_deg"), sum(truth.first));
        noise += sum(error[0]) / sum(radiance[0]);
        ++rows;
    }
    scores.check(file, 40);
    std::printf("    first order: within %.1e; mean standard error %.2f %%\n", first.value(),
                100 * noise / static_cast<double>(rows));
    CHECK_WORST(first, first_limit);
}

/// Air of one kind over the whole shell, thick enough that all orders count, black or bright ground.
AtmosphereParameters even_air(double depth, const PhaseFunction& phase, double albedo = 0.5) {
    AtmosphereParameters air;
    air.planet.ground_albedo = Rgb(albedo);
    air.terms = {even_term(Rgb(depth, 0.5 * depth, 0.1 * depth) / 1e5, Rgb(0.1 * depth) / 1e5, phase)};
    return air;
}

const std::vector<glm::dvec3> some_directions{direction(0.2, 0.4), direction(1.0, 1.0), direction(1.45, 2.5),
                                              direction(1.9, 0.3), direction(3.0, 1)};

TabulatedPhase tabulated(const PhaseFunction& phase) {
    TabulatedPhase table;
    constexpr int samples = 3601;
    for (int i = 0; i < samples; ++i) {
        table.angle_rad.push_back(i == samples - 1 ? pi : pi * i / (samples - 1));
        table.value.push_back(evaluate(phase, std::cos(table.angle_rad.back())));
    }
    return table;
}

/// Two ways of the same light.
void compare(Scores& scores, TracedSky& one, TracedSky& other, double altitude, double sun_zenith_deg, const char* what) {
    static std::uint64_t frame = 0;  // other paths every time, so that errors are independent
    one.frame(++frame);
    other.frame(frame);
    one.stand(altitude, sun_at(sun_zenith_deg * degree));
    other.stand(altitude, sun_at(sun_zenith_deg * degree));
    const auto a = one.look(some_directions), b = other.look(some_directions);
    for (std::size_t i = 0; i < some_directions.size(); ++i)
        for (int c = 0; c < 3; ++c)
            scores.add(a.radiance[i][c] - b.radiance[i][c], std::hypot(a.error[i][c], b.error[i][c]), what, altitude,
                       sun_zenith_deg, i, c, a.radiance[i][c], b.radiance[i][c]);
}

}  // namespace

TEST_CASE("reference: all orders, against independent tables of truth; the first, to its digits") {
    check_truth("earth.csv", presets::earth(), 23, 1e-4);
    check_truth("hazy.csv", presets::hazy_earth(), 6, 1e-5);
    check_truth("mars.csv", presets::mars(), 6, 1e-5);
}

TEST_CASE("reference: thin air is E sigma p(nu) times its length, by nodes and by paths") {
    const Rgb thin(1e-13, 0.7e-13, 0.4e-13);
    const Shell shell;
    for (const PhaseFunction& phase : {PhaseFunction(RayleighPhase{}), PhaseFunction(CornetteShanksPhase{0.8})}) {
        AtmosphereParameters air;
        air.planet.ground_albedo = Rgb(0);
        air.terms = {even_term(thin, Rgb(0), phase)};
        ReferenceSettings settings = paths(256);
        settings.max_order = 1;
        settings.sampled_first_order = true;
        TracedSky by_paths(air, settings);
        Sky by_nodes(cpu_double(), air, traced(paths(4)));
        Worst worst;
        Scores scores;
        const Sun sun = sun_at(40 * degree);
        by_paths.stand(20e3, sun);
        by_nodes.stand(20e3, sun);
        const std::vector<Rgb> nodes = by_nodes.radiance(some_directions);
        const auto sampled = by_paths.look(some_directions);
        for (std::size_t i = 0; i < some_directions.size(); ++i) {
            const double length = static_cast<double>(shell.to_end(20e3, some_directions[i].z));
            const Rgb expected = thin * (length * evaluate(phase, glm::dot(some_directions[i], sun.direction)));
            worst.add(apart(nodes[i], expected), i);
            for (int c = 0; c < 3; ++c) scores.add(sampled.radiance[i][c] - expected[c], sampled.error[i][c], i, c);
        }
        CHECK_WORST(worst, 1e-6);
        scores.check("thin air by paths", 15);
    }
}

TEST_CASE("reference: the first order by paths is that by nodes") {
    Scores scores;
    std::uint64_t frame = 0;
    for (const char* preset : {"earth", "hazy_earth", "mars", "airless"}) {
        ReferenceSettings settings = paths(0);
        settings.max_order = 1;
        TracedSky nodes(presets::by_name(preset), settings);
        settings.paths_per_frame = 2048;
        settings.sampled_first_order = true;
        TracedSky sampled(presets::by_name(preset), settings);
        for (const double altitude : {2.0, 10e3, 300e3})
            for (const double sun : {30.0, 85.0, 94.0}) {
                sampled.frame(++frame);
                nodes.stand(altitude, sun_at(sun * degree));
                sampled.stand(altitude, sun_at(sun * degree));
                const std::vector<Rgb> expected = nodes.radiance(some_directions);
                const auto [radiance, error] = sampled.look(some_directions);
                for (std::size_t i = 0; i < expected.size(); ++i)
                    for (int c = 0; c < 3; ++c) {
                        const double apart = radiance[i][c] - expected[i][c];
                        if (error[i][c] < 1e-4 * expected[i][c] || expected[i][c] < 1e-12)
                            CHECK(std::abs(apart) <= 1e-3 * expected[i][c] + 1e-12);
                        else
                            scores.add(apart, error[i][c], preset, altitude, sun, i, c, radiance[i][c], expected[i][c]);
                    }
            }
    }
    scores.check("first order by paths", 200);
}

TEST_CASE("reference: every phase function is drawn without bias") {
    // The same function as a table is drawn from other lobes; what is seen must be the same.
    const struct {
        const char* name;
        PhaseFunction phase;
    } cases[] = {{"Rayleigh", RayleighPhase{}},
                 {"isotropic", HenyeyGreensteinPhase{0}},
                 {"Henyey-Greenstein 0.85", HenyeyGreensteinPhase{0.85}},
                 {"Henyey-Greenstein -0.5", HenyeyGreensteinPhase{-0.5}},
                 {"Cornette-Shanks 0.8", CornetteShanksPhase{0.8}},
                 {"HG + Draine", HenyeyGreensteinDrainePhase{0.8, 0.4, 10, 0.3}}};
    Scores scores;
    for (const auto& [name, phase] : cases) {
        TracedSky direct(even_air(1.5, phase), paths(1024, 1)), table(even_air(1.5, tabulated(phase)), paths(1024, 2));
        for (const double sun : {20.0, 80.0}) compare(scores, direct, table, 10e3, sun, name);
    }
    scores.check("phase functions and their tables", 150);
}

TEST_CASE("reference: settings that only trade noise for work change nothing else") {
    Scores scores;
    const AtmosphereParameters air = presets::hazy_earth();
    ReferenceSettings late = paths(1024, 3), early = paths(1024, 4), sampled = paths(1024, 5);
    late.roulette_order = 12;
    early.roulette_order = 1;
    sampled.sampled_first_order = true;
    TracedSky base(air, paths(1024, 6)), a(air, late), b(air, early), c(air, sampled);
    for (const double sun : {30.0, 88.0}) {
        compare(scores, base, a, 2, sun, "late roulette");
        compare(scores, base, b, 2, sun, "early roulette");
        compare(scores, base, c, 2, sun, "first order by paths");
    }
    scores.check("roulette, first order", 80);
}

TEST_CASE("reference: orders add up") {
    // Air so thin that the second order is a thousandth of the first and the third nothing, over black ground.
    const AtmosphereParameters air = even_air(1e-3, RayleighPhase{}, 0);
    ReferenceSettings settings = paths(256);
    std::vector<Rgb> upto[4];
    for (int order = 1; order <= 3; ++order) {
        settings.max_order = order;
        TracedSky sky(air, settings);
        sky.stand(1000, sun_at(30 * degree));
        upto[order] = sky.radiance(some_directions);
    }
    for (std::size_t i = 0; i < some_directions.size(); ++i) {
        if (some_directions[i].z < 0) continue;
        CAPTURE(i);
        const double first = sum(upto[1][i]), second = sum(upto[2][i]) - first, third = sum(upto[3][i]) - first - second;
        CHECK(first > 0);
        CHECK(second > 0);
        CHECK(third > 0);
        CHECK(third < 1e-1 * second);
    }
}
