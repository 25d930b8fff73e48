#include "measure/compare.h"

#include <aureole/rhi/error.h>

#include <algorithm>

namespace aureole::app {
namespace {

/// Of the points of which there is one.
class Errors {
public:
    void add(const std::optional<double>& error) {
        if (error) errors_.push_back(*error);
    }
    [[nodiscard]] ErrorSummary summary() const { return summarize(errors_); }

private:
    std::vector<double> errors_;
};

ErrorParts parts_of(const Place& place, const Looks& looks) {
    Errors rounding, discretisation, model;
    for (std::size_t i = 0; i < place.points.size(); ++i) {
        const TrueValue& truth = place.truth[i];
        const Rgb &run = looks.run->points[i], &exact = looks.exact->points[i], &fine = looks.converged->points[i];
        rounding.add(part_of_error(run, exact, truth));
        discretisation.add(part_of_error(exact, fine, truth));
        model.add(part_of_error(fine, truth.value, truth));
    }
    return {rounding.summary(), discretisation.summary(), model.summary()};
}

}  // namespace

std::vector<Place> places_of(const Suite& suite, std::size_t air, const TruthTable& truth) {
    std::vector<Place> places;
    std::size_t missing = 0;
    for (const std::size_t index : suite.scenes_of(air)) {
        const SuiteScene& scene = suite.scenes[index];
        const Planet& planet = suite.airs[air].parameters.planet;
        Place& place = places.emplace_back();
        place.scene = index;
        place.points = points_of(planet, scene.sun_zenith_deg(), scene.altitude_km());
        place.scan = scan_of(planet, scene.sun_zenith_deg(), scene.altitude_km());
        for (const Point& point : place.points) {
            const TruthTable::Entry* entry = truth.find(point.row);
            place.truth.push_back(entry ? entry->radiance : TrueValue{});
            if (!entry) ++missing;
        }
        place.exposure = fixed_exposure(place.truth);
    }
    if (missing > 0)
        throw Error(ErrorCode::invalid_argument, truth_file(suite, suite.airs[air]).string() + " lacks " +
                                                     std::to_string(missing) +
                                                     " directions of the suite; `aureole truth` adds them");
    return places;
}

std::vector<Seen> look(Backend& backend, const Prepared& prepared, std::span<const Place> places) {
    std::vector<ProbeRow> rows;
    for (const Place& place : places) {
        for (const Point& point : place.points) rows.push_back(point.row);
        rows.insert(rows.end(), place.scan.begin(), place.scan.end());
    }
    const std::vector<Rgb> radiance = probe(backend, prepared.air, prepared.model, rows);
    std::vector<Seen> result;
    auto next = radiance.begin();
    const auto take = [&](std::size_t count) {
        std::vector<Rgb> taken(next, next + static_cast<std::ptrdiff_t>(count));
        next += static_cast<std::ptrdiff_t>(count);
        return taken;
    };
    for (const Place& place : places) {
        std::vector<Rgb> points = take(place.points.size());
        result.push_back({std::move(points), take(place.scan.size())});
    }
    return result;
}

SceneResult compare(const Place& place, const Looks& looks) {
    SceneResult result;
    result.scene = place.scene;
    Errors all, colours;
    std::array<Errors, region_names.size()> regions;
    for (std::size_t i = 0; i < place.points.size(); ++i) {
        const std::optional<double> error = relative_error(looks.run->points[i], place.truth[i]);
        all.add(error);
        regions[static_cast<std::size_t>(place.points[i].region)].add(error);
        if (error) colours.add(shown_difference(looks.run->points[i], place.truth[i].value, place.exposure));
    }
    result.all = all.summary();
    std::ranges::transform(regions, result.regions.begin(), &Errors::summary);
    result.luminance_rmse = luminance_rmse(looks.run->points, place.truth);
    result.delta_e = colours.summary();
    if (!looks.exact || !looks.converged) return result;
    result.parts = parts_of(place, looks);
    if (!place.scan.empty()) result.banding = banding(looks.run->scan, looks.converged->scan, place.exposure);
    return result;
}

}  // namespace aureole::app
