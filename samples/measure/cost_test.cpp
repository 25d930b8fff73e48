#include "measure/cost.h"

#include "app/bench.h"
#include "io/test_files.h"
#include "plan/work.h"

#include <aureole/models/aureole.h>
#include <aureole/models/hillaire.h>
#include <aureole/presets.h>

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::app;

namespace {

CostOptions quick() {
    CostOptions options;
    options.width = 16;
    options.height = 8;
    options.rounds = 1;
    options.warm_up = 0;
    return options;
}

}  // namespace

TEST_CASE("costs: what bench says of the same model in the same air, added up") {
    const auto backend = open_backend({.name = "cpu"});
    BenchOptions options;
    options.width = 16;
    options.height = 8;
    options.frames = 1;
    options.warm_up = 0;
    options.models = {{"hillaire", "default"}, {"aureole", "low"}};
    std::vector<CostSubject> subjects;
    for (const SceneModel& model : options.models) subjects.push_back({model.name, presets::earth(), model.make()});
    const std::vector<BenchResult> benched = bench(*backend, options, [] {});
    int rounds = 0;
    const std::vector<Cost> found = costs(*backend, subjects, quick(), [&] { ++rounds; });
    CHECK(rounds == 1);
    REQUIRE(found.size() == 2);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const BenchResult& bench = benched[i];
        CAPTURE(bench.label());
        rhi::CpuCounts air, view;
        for (std::size_t pass = 0; pass < bench.air_passes + bench.view_passes; ++pass)
            (pass < bench.air_passes ? air : view) += bench.passes[pass].counts;
        const Cost& cost = found[i];
        rhi::CpuCounts frame = view;
        frame += bench.pass("composite").counts;
        CHECK(cost.per_frame.evaluations == frame.evaluations);
        // The horizon is elsewhere in a picture of so few pixels.
        CHECK(static_cast<double>(cost.per_frame.samples) ==
              doctest::Approx(static_cast<double>(frame.samples)).epsilon(0.005).scale(1e-300));
        CHECK(cost.per_frame.samples > view.samples);
        CHECK(cost.per_frame.bytes == frame.bytes);
        CHECK(cost.rebuild.evaluations == view.evaluations + air.evaluations);
        CHECK(cost.rebuild.fetches == view.fetches + air.fetches);
        CHECK(cost.rebuild.bytes > view.bytes);
        CHECK(cost.table_bytes == bench.table_bytes);
        CHECK(cost.per_frame_ms.median > 0);
        CHECK(cost.rebuild_ms.median > 0);
        CHECK(cost.per_frame_ms.median > cost.composite_ms.median);
        CHECK(cost.composite_ms.median > 0);
    }
    // As published: 256 x 64 texels with 40 evaluations each.
    CHECK(found[0].rebuild.evaluations - found[0].per_frame.evaluations > 256 * 64 * 40);
}

TEST_CASE("costs: every air has its own, over black ground too") {
    const auto backend = open_backend({.name = "cpu"});
    AtmosphereParameters two = presets::earth(), black = presets::earth();
    two.terms.resize(1);
    black.planet.ground_albedo = Rgb(0);
    const ModelPtr model = models::aureole(QualitySettings::low());
    const std::vector<CostSubject> subjects{
        {"earth", presets::earth(), model}, {"molecules", two, model}, {"black", black, model}};
    CostOptions options = quick();
    options.rounds = 3;
    const std::vector<Cost> found = costs(*backend, subjects, options);
    REQUIRE(found.size() == 3);
    CHECK(found[1].per_frame.bytes < found[0].per_frame.bytes);  // no layers for a sharp phase function
    CHECK(found[2].rebuild.bytes == found[0].rebuild.bytes);
    for (const Cost& cost : found) CHECK(cost.rebuild_ms.p10 > cost.per_frame_ms.p10);
    CHECK(found[2].rebuild_ms.median > 1.2 * found[2].per_frame_ms.median);  // rebuilt in most rounds
}

TEST_CASE("costs: the work of another air is foretold by the settings that it gets") {
    const auto backend = open_backend({.name = "cpu"});
    const ModelPtr model = models::aureole();
    std::vector<CostSubject> subjects;
    for (const char* air : {"earth", "hazy_earth", "mars", "us_standard_1976"})
        subjects.push_back({air, presets::by_name(air), model});
    AtmosphereParameters thick = presets::hazy_earth();
    for (DensityTerm& term : thick.terms)
        if (term.name == "mie") term.scattering_scale = term.absorption_scale = 4;
    subjects.push_back({"thick haze", thick, model});
    const std::vector<Cost> found = costs(*backend, subjects, quick());
    const auto reads = [&](std::size_t i) {
        const rhi::CpuCounts &all = found[i].rebuild, &frame = found[i].per_frame;
        return static_cast<double>(all.samples + all.fetches) - static_cast<double>(frame.samples + frame.fetches) +
               2.4 * (static_cast<double>(all.evaluations) - static_cast<double>(frame.evaluations));
    };
    const detail::TableWork earth = detail::table_work(*model, subjects[0].air);
    for (std::size_t i = 1; i < subjects.size(); ++i) {
        CAPTURE(subjects[i].label);
        const detail::TableWork work = detail::table_work(*model, subjects[i].air);
        const auto ratio = [&](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); };
        const double within =
            std::string_view(subjects[i].label).find("haz") != std::string_view::npos
                ? 0.25  // an opaque ray is cut, and its nodes placed again: counted, but next to nothing in milliseconds
                : 0.15;
        if (subjects[i].label != "us_standard_1976")  // look-ups of a profile are many, and cheap
            CHECK(work.rebuild / earth.rebuild == doctest::Approx(reads(i) / reads(0)).epsilon(within).scale(1e-300));
        CHECK(work.air_memory / earth.air_memory ==
              doctest::Approx(ratio(found[i].air_bytes, found[0].air_bytes)).epsilon(0.02).scale(1e-300));
    }
}

TEST_CASE("costs: features are told apart: a second sun, and shadows where the model has them") {
    const auto backend = open_backend({.name = "cpu"});
    CostOptions options = quick();
    options.features = true;
    options.rounds = 3;
    const std::vector<CostSubject> subjects{{"low", presets::earth(), models::aureole(QualitySettings::low())},
                                            {"fog", presets::earth(), model_by_name("fog")}};
    const std::vector<Cost> found = costs(*backend, subjects, options);
    CHECK(found[0].composite_two_suns_ms.median > 0);
    CHECK(found[0].shadows_ms.median > 0);
    CHECK(found[0].composite_shadows_ms.median > 0);
    CHECK(found[0].shadow_bytes > 0);
    CHECK(found[1].composite_two_suns_ms.median > 0);
    CHECK(found[1].shadows_ms.median == 0);
    CHECK(found[1].composite_shadows_ms.median == 0);
    CHECK(found[1].shadow_bytes == 0);
    options.features = false;
    const Cost plain = costs(*backend, {subjects.data(), 1}, options).at(0);
    CHECK(plain.shadows_ms.median == 0);
    CHECK(plain.table_bytes == found[0].table_bytes);
    CHECK(plain.per_frame.evaluations == found[0].per_frame.evaluations);
}

TEST_CASE("costs: errors name the subject") {
    const auto backend = open_backend({.name = "cpu"});
    AtmosphereParameters wrong = presets::earth();
    wrong.planet.top_radius_m = 1;
    const ModelPtr model = models::aureole(QualitySettings::low());
    const std::vector<CostSubject> subjects{{"earth", presets::earth(), model}, {"aureole low in flat air", wrong, model}};
    CHECK(
        contains(complaint([&] { (void)costs(*backend, subjects, quick()); }), "aureole low in flat air: planet.top_radius_m"));
    CostOptions none = quick();
    none.rounds = 0;
    CHECK(contains(complaint([&] { (void)costs(*backend, subjects, none); }), "rounds: 0"));
    CHECK(costs(*backend, {}, quick()).empty());
}

TEST_CASE("costs: rounds of an earlier run count, and only what is missing is run") {
    const auto backend = open_backend({.name = "cpu"});
    const ModelPtr low = models::aureole(QualitySettings::low());
    const std::vector<CostSubject> subjects{{"low", presets::earth(), low}, {"low on Mars", presets::mars(), low}};
    std::vector<CostRound> measured[2];
    CostOptions options = quick();
    options.rounds = 2;
    options.after_measured = [&](std::size_t subject, const CostRound& round) { measured[subject].push_back(round); };
    (void)costs(*backend, subjects, options);
    REQUIRE(measured[0].size() == 2);
    REQUIRE(measured[1].size() == 2);
    for (CostRound& round : measured[0])
        for (PassTime& time : round)
            if (time.name == "composite") time.milliseconds = 1e6;
    measured[1].pop_back();  // as if it had been stopped between the two
    options.known = {measured[0], measured[1]};
    options.rounds = 3;
    int run[2] = {0, 0};
    options.after_measured = [&](std::size_t subject, const CostRound&) { ++run[subject]; };
    const std::vector<Cost> found = costs(*backend, subjects, options);
    CHECK(run[0] == 1);
    CHECK(run[1] == 2);
    CHECK(found.at(0).composite_ms.median == 1e6);
    CHECK(found.at(0).composite_ms.p10 < 1e6);
    options.rounds = 1;
    run[0] = run[1] = 0;
    CHECK(costs(*backend, subjects, options).at(0).per_frame_ms.median > 1e6);
    CHECK(run[0] + run[1] == 0);
}
