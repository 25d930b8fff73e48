// The path tracer against closed forms, quadrature of the tests' own, tables of truth, and itself.
#include <aureole/models/reference.h>
#include <doctest/doctest.h>

#include "physics/reference.h"
#include "physics/sky.h"
#include "physics/truth.h"
#include "physics/worst.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

using namespace aureole;
using namespace aureole::physics;
using models::ReferenceSettings;

namespace {

SkyOptions traced(const ReferenceSettings& settings) {
    SkyOptions options;
    options.model = models::reference(settings);
    return options;
}
ReferenceSettings paths(int count, int seed = 1) {
    ReferenceSettings settings;
    settings.paths_per_frame = count;
    settings.seed = seed;
    return settings;
}

/// The same sky with its standard error: two composites, one showing each.
class Measured {
public:
    Measured(const AtmosphereParameters& air, ReferenceSettings settings)
        : mean_(cpu_double(), air, traced(settings)), error_(cpu_double(), air, traced(error_of(settings))) {}
    void stand(double altitude_m, const Sun& sun) {
        mean_.stand(altitude_m, sun);
        error_.stand(altitude_m, sun);
    }
    void frame(std::uint64_t number) {
        mean_.air().set_frame(number);
        error_.air().set_frame(number);
    }
    struct Values {
        std::vector<Rgb> radiance, error;
    };
    [[nodiscard]] Values look(std::span<const glm::dvec3> directions) {
        return {mean_.radiance(directions), error_.radiance(directions)};
    }

private:
    static ReferenceSettings error_of(ReferenceSettings settings) {
        settings.show = ReferenceSettings::Show::standard_error;
        return settings;
    }
    Sky mean_, error_;
};

/// Differences in standard errors.
struct Scores {
    std::vector<double> all;
    Worst worst;
    template <class... Where>
    void add(double difference, double error, const Where&... where) {
        const double score = std::abs(difference) / error;
        all.push_back(score);
        worst.add(score, where...);
    }
    [[nodiscard]] double rms() const {
        double sum = 0;
        for (const double score : all) sum += score * score;
        return std::sqrt(sum / static_cast<double>(all.size()));
    }
    [[nodiscard]] double share_beyond(double limit) const {
        const auto count = std::count_if(all.begin(), all.end(), [&](double score) { return score > limit; });
        return static_cast<double>(count) / static_cast<double>(all.size());
    }
};
/// As numbers of a normal distribution are: three of a thousand lie beyond three standard errors.
void check_normal(const char* what, const Scores& scores, std::size_t least) {
    INFO(what, ": ", scores.worst.where());
    std::printf("%-28s %4zu values, rms %.2f, worst %.2f standard errors, %.1f %% beyond 3\n", what, scores.all.size(),
                scores.rms(), scores.worst.value(), 100 * scores.share_beyond(3));
    CHECK(scores.all.size() >= least);
    CHECK(scores.rms() < 1.3);
    CHECK(scores.share_beyond(3) < 0.015);
    CHECK(scores.worst.value() < 4.5);
}

void check_truth(const char* file, const AtmosphereParameters& air, std::size_t every, int count) {
    const TruthTable table = read_truth(file);
    constexpr const char* channels[] = {"r_per_sr", "g_per_sr", "b_per_sr"};
    Measured sky(air, paths(count));
    Scores scores, first;
    for (std::size_t i = 0; i < table.rows.size(); i += every) {
        const auto& row = table.rows[i];
        sky.stand(number(row, "altitude_km") * 1000, sun_at(number(row, "sun_zenith_deg") * degree));
        const glm::dvec3 view = direction(number(row, "view_zenith_deg") * degree, number(row, "azimuth_deg") * degree);
        const auto [radiance, error] = sky.look(std::span(&view, 1));
        for (int c = 0; c < 3; ++c) {
            const double truth = number(row, std::string("L_") + channels[c]);
            const double truth_error = number(row, std::string("stderr_") + channels[c]);
            if (!(truth_error > 0)) continue;
            scores.add(radiance[0][c] - truth, std::hypot(error[0][c], truth_error), file, i, c, radiance[0][c], truth,
                       error[0][c], truth_error);
        }
    }
    check_normal(file, scores, 30);
}

}  // namespace

TEST_CASE("reference: all orders, against independent tables of truth") {
    check_truth("earth.csv", presets::earth(), 37, 2048);
    check_truth("hazy.csv", presets::hazy_earth(), 7, 2048);
    check_truth("mars.csv", presets::mars(), 7, 2048);
}
