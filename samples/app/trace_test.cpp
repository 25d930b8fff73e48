#include "app/trace.h"

#include "app/trace_checkpoint.h"
#include "app/trace_run.h"
#include "io/test_files.h"

#include <aureole/models/aureole.h>
#include <aureole/models/reference.h>
#include <aureole/models/spectral.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

using namespace aureole;
using namespace aureole::app;

namespace {

using Tracking = models::ReferenceSettings::Tracking;

std::unique_ptr<Backend> cpu_double(unsigned threads = 0) { return open_backend({.name = "cpu-double", .threads = threads}); }

/// The least work that there is.
TraceSettings quick(double error = 1) {
    TraceSettings settings;
    settings.error = error;
    return settings;
}

const std::vector<ProbeRow> some_rows{{60, 0.2, 30, 45}, {60, 0.2, 120, 90}, {92, 10, 85, 0}};

void finish(Tracer& tracer) {
    while (tracer.step()) {
    }
}

}  // namespace

TEST_CASE("trace: an error of no light is infinite, and no division by it") {
    CHECK(relative_error({Rgb(0, 2, 1), Rgb(0, 1, 0.1)}) == 0.5);
    CHECK(relative_error({Rgb(0, 2, 1), Rgb(1e-300, 1, 0.1)}) == std::numeric_limits<double>::infinity());
}

TEST_CASE("trace: rows of an independent table of truth, and their first orders") {
    // From tests/truth/earth.csv: radiance, its standard error, scattered once, reflected once; red, green, blue.
    const struct {
        ProbeRow row;
        Rgb all, error, first_air, first_ground;
    } truths[] = {
        {{60, 0.2, 30, 45},
         {0.00621918, 0.01314848, 0.03039305},
         {3.2e-06, 8.56e-06, 4.21e-05},
         {0.0047236911, 0.0092811529, 0.018446097},
         {0.0, 0.0, 0.0}},
        {{85, 10, 120, 90},
         {0.009208233, 0.008939231, 0.01176349},
         {3e-06, 5.26e-06, 1.38e-05},
         {0.0026401945, 0.0034350252, 0.0040513934},
         {0.0041887641, 0.0017588119, 0.00035866804}},
        {{92, 0.2, 85, 0},
         {0.01011832, 0.005056491, 0.003230212},
         {7.46e-06, 4.73e-06, 8.88e-06},
         {0.0090668977, 0.004105442, 0.0017459361},
         {0.0, 0.0, 0.0}},
    };
    std::vector<ProbeRow> rows;
    for (const auto& truth : truths) rows.push_back(truth.row);
    const auto backend = cpu_double();
    Tracer tracer(*backend, presets::earth(), rows, quick(0.02));
    CHECK(tracer.done() == 0);
    CHECK(tracer.share() == 0);
    double share = 0;
    while (tracer.step()) share = std::max(share, tracer.share());
    CHECK(share > 0.3);
    CHECK(tracer.done() == rows.size());
    CHECK(tracer.share() == 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        const TraceResult result = tracer.result(i);
        CHECK(tracer.reached(i));
        CHECK(relative_error(result.all) <= 0.02);
        CHECK(result.paths >= 4096);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            const auto& truth = truths[i];
            CHECK(std::abs(result.all.radiance[c] - truth.all[c]) < 4 * std::hypot(result.all.error[c], truth.error[c]));
            CHECK(result.first_air[c] == doctest::Approx(truth.first_air[c]).scale(1e-300).epsilon(1e-4));
            CHECK(result.first_ground[c] == doctest::Approx(truth.first_ground[c]).scale(1e-300).epsilon(1e-4));
        }
    }
}

TEST_CASE("trace: the stated error is that by which seeds scatter" * doctest::test_suite("long")) {
    const auto backend = cpu_double();
    constexpr int seeds = 20;
    const std::vector<ProbeRow> rows{some_rows[0], some_rows[2]};
    std::vector<TraceResult> results;
    for (int seed = 0; seed < seeds; ++seed) {
        TraceSettings settings = quick();
        settings.seed = seed;
        Tracer tracer(*backend, presets::earth(), rows, settings);
        finish(tracer);
        for (std::size_t i = 0; i < rows.size(); ++i) results.push_back(tracer.result(i));
    }
    double squares = 0, worst = 0;
    int values = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            double mean = 0;
            for (std::size_t s = 0; s < seeds; ++s) mean += results[s * rows.size() + i].all.radiance[c] / seeds;
            for (std::size_t s = 0; s < seeds; ++s) {
                const Estimated& one = results[s * rows.size() + i].all;
                const double score = (one.radiance[c] - mean) / one.error[c];
                squares += score * score;
                worst = std::max(worst, std::abs(score));
                ++values;
            }
            // The mean itself takes one of the degrees of freedom.
            values -= 1;
        }
    const double rms = std::sqrt(squares / values);
    std::printf("trace: %d seeds scatter by %.3f of the stated error, worst %.2f\n", seeds, rms, worst);
    // 38 independent values or more (channels share paths): 11 % of scatter.
    CHECK(rms > 0.7);
    CHECK(rms < 1.35);
    CHECK(worst < 4.5);
}

TEST_CASE("trace: interrupted and resumed is the same to the bit, with any number of threads") {
    TraceSettings settings = quick(0.0035);
    settings.orders = 2;
    const AtmosphereParameters air = presets::earth();
    const TraceParameters parameters{{"seed", "0"}};
    const auto one = cpu_double(1), two = cpu_double(2);
    Tracer whole(*one, air, some_rows, settings);
    finish(whole);
    CHECK(whole.states()[0].rounds != whole.states()[1].rounds);

    const std::filesystem::path file = "trace.json";
    {
        Tracer first(*two, air, some_rows, settings);
        REQUIRE(first.step());
        REQUIRE(first.step());
        const std::vector<TraceState> before = first.states();
        REQUIRE(first.step([] { return true; }));  // stopped halfway: as if it had not begun
        CHECK(first.states() == before);
        write_checkpoint(file, parameters, first);
    }
    std::size_t pieces = 0;
    for (bool more = true; more; ++pieces) {
        Tracer next(*two, air, some_rows, settings);
        read_checkpoint(file, parameters, next);
        more = next.step();
        write_checkpoint(file, parameters, next);
    }
    CHECK(pieces > 2);
    Tracer resumed(*two, air, some_rows, settings);
    read_checkpoint(file, parameters, resumed);
    CHECK(resumed.states() == whole.states());
    CHECK_FALSE(resumed.step());
}

TEST_CASE("trace: going on to a smaller error is the same as having wanted it at once, whatever else is traced") {
    const auto backend = cpu_double();
    const AtmosphereParameters air = presets::earth();
    Tracer coarse(*backend, air, some_rows, quick(0.03));
    finish(coarse);
    Tracer further(*backend, air, some_rows, quick(0.0035)), at_once(*backend, air, some_rows, quick(0.0035));
    further.restore(coarse.states());
    finish(further);
    finish(at_once);
    CHECK(further.states() == at_once.states());
    CHECK(further.states() != coarse.states());
    Tracer alone(*backend, air, {some_rows[0]}, quick(0.0035));
    finish(alone);
    CHECK(alone.states()[0] == at_once.states()[0]);

    TraceSettings other = quick(0.0035);
    other.seed = 1;
    Tracer another(*backend, air, {some_rows[0]}, other);
    finish(another);
    CHECK(another.states()[0].tallies[0].mean != alone.states()[0].tallies[0].mean);
}

TEST_CASE("trace: --max-paths ends what would take longer") {
    const auto backend = cpu_double();
    TraceSettings settings = quick(1e-6);
    settings.max_paths = 3 * trace_round_paths + 5;
    Tracer tracer(*backend, presets::earth(), {some_rows[0]}, settings);
    finish(tracer);
    CHECK(tracer.result(0).paths == 3 * trace_round_paths);
    CHECK_FALSE(tracer.reached(0));
}

TEST_CASE("trace: where nothing is random there is no error") {
    const auto backend = cpu_double();
    // An airless body: bright ground, and black sky.
    Tracer tracer(*backend, presets::airless(), {{30, 1, 180, 0}, {30, 1, 20, 0}}, quick(1e-6));
    finish(tracer);
    const TraceResult ground = tracer.result(0), sky = tracer.result(1);
    const Rgb albedo = presets::airless().planet.ground_albedo;
    CHECK(ground.all.radiance.g == doctest::Approx(albedo.g / std::numbers::pi * std::cos(30 * std::numbers::pi / 180)));
    CHECK(ground.first_ground.g == ground.all.radiance.g);
    CHECK(ground.first_air.g == 0);
    CHECK(relative_error(ground.all) < 1e-12);
    CHECK(sky.all.radiance == Rgb(0));
    CHECK(sky.all.error == Rgb(0));
    CHECK(sky.paths == trace_least_rounds * trace_round_paths);
}

TEST_CASE("trace: orders one by one, against others' paths" * doctest::test_suite("long")) {
    const auto backend = cpu_double();
    const AtmosphereParameters air = presets::hazy_earth();
    const std::vector<ProbeRow> rows{{60, 0.2, 60, 90}};
    TraceSettings settings = quick();
    settings.orders = 3;
    Tracer tracer(*backend, air, rows, settings);
    finish(tracer);
    const TraceResult result = tracer.result(0);
    REQUIRE(result.orders.size() == 3);
    constexpr int paths = 2048;
    const auto up_to = [&](int order) {
        models::ReferenceSettings reference;
        reference.max_order = order;
        reference.paths_per_frame = paths;
        reference.seed = 100000 + order;
        return probe(*backend, air, models::reference(reference), rows)[0];
    };
    // The other's noise is at most that of all orders, of two independent sums.
    const Rgb noise = result.all.error * std::sqrt(2 * static_cast<double>(result.paths) / paths);
    Rgb before = up_to(1), sum = result.orders[0].radiance;
    CHECK(sum.g == doctest::Approx(before.g));
    CHECK(result.orders[0].error == Rgb(0));
    for (int order = 2; order <= settings.orders; ++order) {
        CAPTURE(order);
        const Rgb all = up_to(order);
        const Estimated& one = result.orders[static_cast<std::size_t>(order - 1)];
        for (int c = 0; c < 3; ++c) {
            CHECK(one.error[c] > 0);
            CHECK(one.error[c] < result.all.error[c]);
            CHECK(std::abs(one.radiance[c] - (all[c] - before[c])) < 4 * std::hypot(one.error[c], noise[c]));
        }
        CHECK(one.radiance.g > 4 * noise.g);  // so that the wrong order would show
        sum += one.radiance;
        before = all;
    }
    for (int c = 0; c < 3; ++c) {
        CHECK(sum[c] < result.all.radiance[c]);
        CHECK(sum[c] > 0.6 * result.all.radiance[c]);
    }
}

TEST_CASE("trace: in wavelengths, against tables in wavelengths") {
    const auto backend = cpu_double();
    const AtmosphereParameters air = presets::earth();
    const std::vector<ProbeRow> rows{{60, 0.2, 30, 45}};
    TraceSettings settings = quick();
    settings.spectral = "4";
    Tracer tracer(*backend, air, rows, settings);
    finish(tracer);
    const auto set = models::wavelengths_by_name("4");
    const std::vector<Rgb> tables =
        probe(*backend, air, models::spectral(models::aureole(QualitySettings::standard()), {.wavelengths = set}), rows);
    const std::vector<Rgb> in_rgb = probe(*backend, air, models::aureole(QualitySettings::standard()), rows);
    double apart_from_rgb = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            CAPTURE(i);
            CAPTURE(c);
            const Estimated all = tracer.result(i).all;
            CHECK(std::abs(all.radiance[c] - tables[i][c]) < 0.01 * tables[i][c] + 3 * all.error[c]);
            apart_from_rgb = std::max(apart_from_rgb, std::abs(all.radiance[c] / in_rgb[i][c] - 1));
        }
    CHECK(apart_from_rgb > 0.1);
}

TEST_CASE("trace: ratio tracking finds what quadrature finds, by paths alone, and says so") {
    const auto backend = cpu_double();
    const std::vector<ProbeRow> rows{{60, 0.2, 60, 90}};
    TraceSettings nodes = quick(), ratio = quick();
    ratio.tracking = Tracking::ratio;
    ratio.seed = 1;
    Tracer by_nodes(*backend, presets::earth(), rows, nodes), by_ratio(*backend, presets::earth(), rows, ratio);
    finish(by_nodes);
    finish(by_ratio);
    const TraceResult a = by_nodes.result(0), b = by_ratio.result(0);
    CHECK(b.first_air == a.first_air);
    for (int c = 0; c < 3; ++c) {
        CHECK(b.all.error[c] > 0);
        CHECK(std::abs(a.all.radiance[c] - b.all.radiance[c]) < 4 * std::hypot(a.all.error[c], b.all.error[c]));
    }
    const auto tells = [&](const TraceSettings& settings) {
        return std::ranges::count(parameters_of(presets::earth(), settings, *backend),
                                  std::pair<std::string, std::string>("tracking", "ratio"));
    };
    CHECK(tells(nodes) == 0);
    CHECK(tells(ratio) == 1);
}

TEST_CASE("trace: another trace's checkpoint is refused by what differs") {
    const auto backend = cpu_double();
    const AtmosphereParameters earth = presets::earth();
    TraceParameters parameters = describe(earth);
    parameters.emplace_back("seed", "3");
    Tracer tracer(*backend, earth, some_rows, quick());
    REQUIRE(tracer.step());
    const std::vector<TraceState> states = tracer.states();
    write_checkpoint("right.json", parameters, tracer);
    const auto says = [&](const TraceParameters& others, Tracer& other) {
        return complaint([&] { read_checkpoint("right.json", others, other); });
    };
    CHECK(says(parameters, tracer) == "nothing");

    TraceParameters seed = parameters;
    seed.back().second = "4";
    CHECK(says(seed, tracer) == "right.json is the checkpoint of another trace: seed is 3 there and 4 here");
    AtmosphereParameters thinner = earth;
    thinner.terms[1].scattering_scale = 0.5;
    TraceParameters air = describe(thinner);
    air.emplace_back("seed", "3");
    CHECK(contains(says(air, tracer),
                   "term2_scattering_per_km is 0.003996,0.003996,0.003996 there and 0.001998,0.001998,0.001998 here"));
    TraceParameters fewer = parameters, more = parameters;
    fewer.pop_back();
    more.emplace_back("orders", "2");
    CHECK(contains(says(fewer, tracer), "seed is 3 there and absent here"));
    CHECK(contains(says(more, tracer), "orders is absent there and 2 here"));
    std::vector<ProbeRow> rows = some_rows;
    rows[1].view_zenith_deg = 121;
    Tracer others(*backend, earth, rows, quick());
    CHECK(contains(says(parameters, others),
                   "direction 2 [sun_zenith_deg, altitude_km, view_zenith_deg, azimuth_deg] is "
                   "[60.0,0.2,120.0,90.0] there and [60.0,0.2,121.0,90.0] here"));
    Tracer single(*backend, earth, {some_rows[0]}, quick());
    CHECK(contains(says(parameters, single), "the number of directions is 3 there and 1 here"));
    for (const char* text : {"", "{}", "[1]", "{\"format\": \"aureole trace checkpoint 2\"}", "not JSON",
                             "{\"format\": \"aureole trace checkpoint 1\", \"parameters\": 3}"}) {
        CAPTURE(text);
        const auto bad = put("bad.json", text);
        CHECK(complaint([&] { read_checkpoint(bad, parameters, tracer); }) == "bad.json: not a checkpoint of trace");
    }
    const std::string text = get("right.json");  // ..."states":[[1,[
    const std::size_t rounds = text.find("[[", text.find("states")) + 2;
    for (const std::string count : {"1e300", "-1", "1.5", "true"}) {
        CAPTURE(count);
        const auto bad = put("bad.json", std::string(text).replace(rounds, 1, count));
        CHECK(contains(complaint([&] { read_checkpoint(bad, parameters, tracer); }), "bad.json: rounds: "));
    }
    CHECK(contains(complaint([&] { read_checkpoint("none.json", parameters, tracer); }), "there is no such file"));
    CHECK(tracer.states() == states);
    CHECK(contains(complaint([&] { tracer.restore({}); }), "as many as there are rows"));
}

TEST_CASE("trace: settings and rows out of range are named") {
    const auto backend = cpu_double();
    const auto says = [&](const std::function<void(TraceSettings&)>& change, std::vector<ProbeRow> rows = {{60, 0, 0, 0}}) {
        TraceSettings settings;
        change(settings);
        return complaint([&] { const Tracer tracer(*backend, presets::earth(), rows, settings); });
    };
    CHECK(contains(says([](TraceSettings& s) { s.error = 0; }), "error: 0"));
    CHECK(contains(says([](TraceSettings& s) { s.error = std::nan(""); }), "error"));
    CHECK(contains(says([](TraceSettings& s) { s.max_paths = 4095; }), "max_paths: 4095"));
    CHECK(contains(says([](TraceSettings& s) { s.orders = 65; }), "orders: 65"));
    CHECK(
        contains(says([](TraceSettings& s) { s.orders = 2, s.tracking = Tracking::ratio; }), "orders, with ratio tracking: 2"));
    CHECK(contains(says([](TraceSettings& s) { s.seed = 4096; }), "seed: 4096"));
    CHECK(contains(says([](TraceSettings& s) { s.spectral = "2"; }), "spectral"));
    CHECK(contains(says([](TraceSettings&) {}, {}), "rows"));
    CHECK(contains(says([](TraceSettings&) {}, {{60, 0, 0, 0}, {60, 0, 190, 0}}), "row 2: view_zenith_deg: 190"));
}

TEST_CASE("print_parameters: one line") {
    CHECK(print_parameters({{"a", "1"}, {"name", "two\nlines"}}) == "a=1 name=two lines");
    AtmosphereParameters air = presets::us_standard_1976();
    air.terms[0].phase = TabulatedPhase{{0, 3.14159265358979}, {1, 2}};
    const std::string text = print_parameters(describe(air));
    CHECK(contains(text, "term1_profile=tabulated:altitude_m:0,100,200"));
    CHECK(contains(text, "term1_phase=tabulated:angle_rad:0,3.14159265358979:value:1,2"));
    CHECK(contains(text, "bottom_radius_km=6360 "));
}
