#include "measure/compare.h"

#include "app/solution.h"

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

/// Looks values up in a table, and says what to do where there is none.
class Finder {
public:
    Finder(const Suite& suite, std::size_t air, TruthKind kind, const TruthTable& table)
        : suite_(suite), air_(suite.airs[air]), kind_(kind), table_(table) {}
    [[nodiscard]] TrueValue find(const ProbeRow& row) const {
        if (const TruthTable::Entry* entry = table_.find(row)) return entry->value;
        throw Error(ErrorCode::invalid_argument,
                    truth_file(suite_, air_, kind_).string() + " lacks scenes of the suite; `aureole truth` adds them");
    }

private:
    const Suite& suite_;
    const SuiteAir& air_;
    TruthKind kind_;
    const TruthTable& table_;
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

/// Of the two rows of a scan.
double banding_of(const Place& place, const Seen& seen, const Seen& fine) {
    const auto row = [](const Seen& of, std::size_t first, std::size_t count) {
        return std::span(of.scan).subspan(first, count);
    };
    return std::max(banding(row(seen, 0, scan_up), row(fine, 0, scan_up), place.exposure),
                    banding(row(seen, scan_up, scan_across), row(fine, scan_up, scan_across), place.exposure));
}

}  // namespace

std::vector<Place> places_of(const Suite& suite, std::size_t air, const AirTruth& truth) {
    const Finder sky(suite, air, TruthKind::sky, truth.sky), aerial(suite, air, TruthKind::aerial, truth.aerial),
        light(suite, air, TruthKind::light, truth.light);
    std::vector<Place> places;
    for (const std::size_t index : suite.scenes_of(air)) {
        const SuiteScene& scene = suite.scenes[index];
        const Planet& planet = suite.airs[air].parameters.planet;
        Place& place = places.emplace_back();
        place.scene = index;
        place.points = points_of(planet, scene.sun_zenith_deg(), scene.altitude_km());
        place.scan = scan_of(planet, scene.sun_zenith_deg(), scene.altitude_km());
        for (const Point& point : place.points) place.truth.push_back(sky.find(point.row));
        place.exposure = fixed_exposure(place.truth);
        if (scene.aerial) {
            place.aerial = aerial_view(scene);
            const std::vector<double> distances = aerial_distances(planet, *place.aerial);
            for (std::size_t i = 0; i < aerial_pixels; ++i) {
                const TrueValue value = aerial.find(aerial_row(*place.aerial, i));
                if (distances[i] < aerial_nearest_km) continue;
                place.pixels.push_back(i);
                place.truth.push_back(value);
            }
        }
        // Above the air no sky lights a surface that faces up.
        if (planet.bottom_radius_m + scene.altitude_m < planet.top_radius_m)
            place.sky = light.find(light_row(scene, LightPart::sky));
        place.sun = light.find(light_row(scene, LightPart::sun));
    }
    return places;
}

std::vector<Seen> look(Backend& backend, const Prepared& prepared, const Suite& suite, std::span<const Place> places) {
    std::vector<ProbeRow> rows;
    std::vector<AerialView> views;
    std::vector<LightPlace> lights;
    for (const Place& place : places) {
        for (const Point& point : place.points) rows.push_back(point.row);
        rows.insert(rows.end(), place.scan.begin(), place.scan.end());
        if (place.aerial) views.push_back(*place.aerial);
        const SuiteScene& scene = suite.scenes[place.scene];
        lights.push_back({scene.sun_zenith_deg(), scene.altitude_km()});
    }
    const std::unique_ptr<Atmosphere> air = solved(backend, prepared.air, prepared.model);
    const std::vector<Rgb> radiance = probe(backend, *air, rows);
    const std::vector<std::vector<Rgb>> pictures = aerial(backend, *air, views);
    const std::vector<MeasuredLight> light = app::light(backend, *air, lights);
    std::vector<Seen> result;
    auto next = radiance.begin();
    auto picture = pictures.begin();
    const auto take = [&](std::size_t count) {
        std::vector<Rgb> taken(next, next + static_cast<std::ptrdiff_t>(count));
        next += static_cast<std::ptrdiff_t>(count);
        return taken;
    };
    for (const Place& place : places) {
        Seen& seen = result.emplace_back();
        seen.points = take(place.points.size());
        seen.scan = take(place.scan.size());
        seen.light = light[result.size() - 1];
        if (place.aerial) {
            for (const std::size_t pixel : place.pixels) seen.points.push_back((*picture)[pixel]);
            ++picture;
        }
    }
    return result;
}

SceneResult compare(const Place& place, const Looks& looks) {
    SceneResult result;
    result.scene = place.scene;
    Errors all, colours;
    std::array<Errors, region_names.size()> regions;
    const std::span truth = std::span(place.truth).first(place.points.size());
    const std::span seen = std::span(looks.run->points).first(place.points.size());
    for (std::size_t i = 0; i < place.truth.size(); ++i) {
        const std::optional<double> error = relative_error(looks.run->points[i], place.truth[i]);
        const bool is_sky = i < truth.size();
        regions[static_cast<std::size_t>(is_sky ? place.points[i].region : Region::aerial)].add(error);
        if (!is_sky) continue;
        all.add(error);
        if (error) colours.add(shown_difference(seen[i], truth[i].value, place.exposure));
    }
    result.all = all.summary();
    std::ranges::transform(regions, result.regions.begin(), &Errors::summary);
    result.luminance_rmse = luminance_rmse(seen, truth);
    result.delta_e = colours.summary();
    result.sky_illuminance = luminance_error(looks.run->light.sky_irradiance_up, place.sky);
    result.sun_colour = relative_error(looks.run->light.sun_irradiance, place.sun);
    if (!looks.exact || !looks.converged) return result;
    result.parts = parts_of(place, looks);
    if (!place.scan.empty()) result.banding = banding_of(place, *looks.run, *looks.converged);
    return result;
}

}  // namespace aureole::app
