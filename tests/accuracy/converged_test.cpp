// Quality "converged" is what `aureole measure` takes for a model without any discretisation: with coarser tables or fewer
// samples it must show the same. docs/measure.md states what is measured here.
#include "accuracy/measure.h"

#include <aureole/models/hillaire.h>
#include <aureole/models/single_lut.h>
#include <aureole/setting.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>
#include <string>
#include <vector>

using namespace aureole;
using namespace aureole::physics;

namespace {

/// Radiances of a model: day, a low sun and twilight, from the ground and from a mountain, above and below the horizon.
std::vector<Rgb> seen_by(const ModelPtr& model, const AtmosphereParameters& air) {
    SkyOptions options;
    options.model = model;
    Sky sky(cpu_float(), air, options);
    std::vector<glm::dvec3> directions;
    for (const double zenith_deg : {8.0, 45.0, 70.0, 84.0, 88.5, 94.0, 120.0})
        for (const double azimuth_deg : {3.0, 50.0, 110.0, 175.0})
            directions.push_back(direction(zenith_deg * degree, azimuth_deg * degree));
    std::vector<Rgb> all;
    for (const double altitude_m : {2.0, 4000.0})
        for (const double elevation_deg : {50.0, 4.0, -4.0}) {
            sky.stand(altitude_m, sun_at((90 - elevation_deg) * degree));
            const std::vector<Rgb> seen = sky.radiance(directions);
            all.insert(all.end(), seen.begin(), seen.end());
        }
    return all;
}

/// Relative, of every channel with light.
Errors changes(const std::vector<Rgb>& fine, const std::vector<Rgb>& coarse) {
    Errors result;
    for (std::size_t i = 0; i < fine.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (fine[i][c] > 0) result.percent.push_back(100 * std::abs(coarse[i][c] - fine[i][c]) / fine[i][c]);
    return result;
}

void coarser(rhi::Extent& table, std::uint32_t least = 2) {
    for (std::uint32_t* side : {&table.width, &table.height, &table.depth})
        if (*side > 1) *side = std::max(least, *side * 7 / 10 / 2 * 2);
}

ModelPtr coarser_aureole() {
    QualitySettings s = QualitySettings::converged();
    for (rhi::Extent* table : {&s.transmittance, &s.multi_scatter, &s.sky_view, &s.aerial_perspective}) coarser(*table);
    return models::aureole(s);
}

ModelPtr coarser_hillaire() {
    models::HillaireSettings s = models::HillaireSettings::converged();
    for (rhi::Extent* table : {&s.transmittance, &s.multi_scatter, &s.sky_view}) coarser(*table);
    return models::hillaire(s);
}

ModelPtr coarser_single_lut() {
    models::SingleLutSettings s = models::SingleLutSettings::by_name("converged");
    coarser(s.table);
    return models::single_lut(s);
}

ModelPtr fewer_samples(const std::string& model) {
    return prepare({model, "converged", "rgb", {"half the samples"}}, presets::earth())->model;
}

struct Case {
    std::string model, what;
    ModelPtr coarse;
    double median, p95;  ///< The most that may change, in percent: a third more than does.
};

void check_all(std::span<const Case> cases) {
    const AtmosphereParameters air = presets::earth();
    std::map<std::string, std::vector<Rgb>> fine;
    for (const Case& one : cases) {
        const auto& model = one.model;
        const auto& what = one.what;
        const auto& coarse = one.coarse;
        const double median = one.median, p95 = one.p95;
        CAPTURE(model);
        CAPTURE(what);
        if (!fine.contains(model)) fine[model] = seen_by(prepare({model, "converged", "rgb", {}}, air)->model, air);
        Errors change = changes(fine[model], seen_by(coarse, air));
        std::printf("| %s | %s | %.3f | %.3f |\n", model.c_str(), what.c_str(), change.quantile(0.5), change.quantile(0.95));
        CHECK(change.quantile(0.5) <= median);
        CHECK(change.quantile(0.95) <= p95);
        CHECK(change.quantile(1) > 0);  // it is another picture at all
    }
}

}  // namespace

TEST_CASE("converged settings: with coarser tables or half the samples they show the same") {
    const Case cases[] = {
        {"single", "half the samples", fewer_samples("single"), 0.05, 1.6},
        {"single-lut", "half the samples", fewer_samples("single-lut"), 0.05, 1.6},
        {"single-lut", "coarser tables", coarser_single_lut(), 0.01, 0.02},
        {"aureole", "half the samples", fewer_samples("aureole"), 0.05, 1.6},
        {"aureole", "coarser tables", coarser_aureole(), 0.16, 0.9},
    };
    check_all(cases);
}

// Minutes on a CPU: converged_test --no-skip.
TEST_CASE("converged settings of hillaire and bruneton: with coarser tables or half the samples they show the same" *
          doctest::skip()) {
    const Case cases[] = {{"hillaire", "half the samples", fewer_samples("hillaire"), 0.28, 1.6},
                          {"hillaire", "coarser tables", coarser_hillaire(), 0.11, 2.2},
                          {"bruneton", "half the samples", fewer_samples("bruneton"), 0.5, 5}};
    check_all(cases);
}
