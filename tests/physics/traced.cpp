#include "physics/traced.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace aureole::physics {
namespace {

using models::ReferenceSettings;

ReferenceSettings error_of(ReferenceSettings settings) {
    settings.show = ReferenceSettings::Show::standard_error;
    return settings;
}

}  // namespace

ReferenceSettings paths(int count, int seed) {
    ReferenceSettings settings;
    settings.paths_per_frame = count;
    settings.seed = seed;
    return settings;
}

SkyOptions traced(const ReferenceSettings& settings) {
    SkyOptions options;
    options.model = models::reference(settings);
    return options;
}

TracedSky::TracedSky(const AtmosphereParameters& air, const ReferenceSettings& settings)
    : mean_(cpu_double(), air, traced(settings)), error_(cpu_double(), air, traced(error_of(settings))) {}

void TracedSky::stand(double altitude_m, const Sun& sun) {
    mean_.stand(altitude_m, sun);
    error_.stand(altitude_m, sun);
}

void TracedSky::frame(std::uint64_t number) {
    mean_.air().set_frame(number);
    error_.air().set_frame(number);
}

TracedSky::Values TracedSky::look(std::span<const glm::dvec3> directions) {
    return {mean_.radiance(directions), error_.radiance(directions)};
}

void Scores::check(const char* what, std::size_t least) const {
    double sum = 0;
    for (const double score : all_) sum += score * score;
    const double count = static_cast<double>(all_.size()), rms = std::sqrt(sum / count);
    const auto far = std::count_if(all_.begin(), all_.end(), [](double score) { return score > 3; });
    const double share = static_cast<double>(far) / count;
    INFO(what, ": ", worst_.where());
    std::printf("%-32s %4zu values: rms %.2f, worst %.2f standard errors, %.1f %% beyond 3\n", what, all_.size(), rms,
                worst_.value(), 100 * share);
    CHECK(all_.size() >= least);
    CHECK(rms < 1.3);
    CHECK(share < 0.02);
    CHECK(worst_.value() < 4.5);
}

}  // namespace aureole::physics
