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

/// The three of one value that is seen thrice, by `error_of(a, b)`; none where that is none.
template <class ErrorOf, class Value>
std::optional<FigureParts> parts_of(const ErrorOf& error_of, const Value& run, const Value& exact, const Value& fine,
                                    const Value& truth) {
    const std::optional<double> rounding = error_of(run, exact), discretisation = error_of(exact, fine),
                                model = error_of(fine, truth);
    if (!rounding || !discretisation || !model) return {};
    return FigureParts{*rounding, *discretisation, *model};
}

/// Of many directions.
class Parts {
public:
    void add(const std::optional<FigureParts>& of) {
        if (!of) return;
        rounding_.add(of->rounding);
        discretisation_.add(of->discretisation);
        model_.add(of->model);
        sum_.add(of->rounding + of->discretisation + of->model);
    }
    [[nodiscard]] ErrorParts summary() const {
        return {rounding_.summary(), discretisation_.summary(), model_.summary(), sum_.summary()};
    }

private:
    Errors rounding_, discretisation_, model_, sum_;
};

/// Region of an index of Place::truth.
Region region_of(const Place& place, std::size_t i) {
    return i < place.points.size() ? place.points[i].region : Region::aerial;
}

/// Index of aerial_names of one that shows geometry.
std::size_t distance_of(const Place& place, std::size_t i) {
    return place.pixels_km[i - place.points.size()] > detail::near_geometry_km ? 1 : 0;
}

void split(const Place& place, const Looks& looks, SceneResult& result) {
    Parts all;
    std::array<Parts, region_names.size()> regions;
    std::array<Parts, aerial_names.size()> aerial;
    for (std::size_t i = 0; i < place.truth.size(); ++i) {
        const TrueValue& truth = place.truth[i];
        const auto error_of = [&](const Rgb& a, const Rgb& b) { return part_of_error(a, b, truth); };
        const auto parts =
            parts_of(error_of, looks.run->points[i], looks.exact->points[i], looks.converged->points[i], truth.value);
        regions[static_cast<std::size_t>(region_of(place, i))].add(parts);
        (i < place.points.size() ? all : aerial[distance_of(place, i)]).add(parts);
    }
    result.parts = all.summary();
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (result.regions[i].rows > 0) result.region_parts[i] = regions[i].summary();
    for (std::size_t i = 0; i < aerial.size(); ++i)
        if (result.aerial[i].rows > 0) result.aerial_parts[i] = aerial[i].summary();
    const MeasuredLight &run = looks.run->light, &exact = looks.exact->light, &fine = looks.converged->light;
    result.sun_colour_parts = parts_of([&](const Rgb& a, const Rgb& b) { return part_of_error(a, b, place.sun); },
                                       run.sun_irradiance, exact.sun_irradiance, fine.sun_irradiance, place.sun.value);
    result.sky_illuminance_parts =
        parts_of([&](const Rgb& a, const Rgb& b) { return luminance_part(a, b, place.sky); }, run.sky_irradiance_up,
                 exact.sky_irradiance_up, fine.sky_irradiance_up, place.sky.value);
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
                place.pixels_km.push_back(distances[i]);
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

std::vector<Seen> look(Backend& backend, Atmosphere& air, const Suite& suite, std::span<const Place> places) {
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
    const std::vector<Rgb> radiance = probe(backend, air, rows);
    const std::vector<std::vector<Rgb>> pictures = aerial(backend, air, views);
    const std::vector<MeasuredLight> light = app::light(backend, air, lights);
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
    std::array<Errors, aerial_names.size()> aerial;
    const std::span truth = std::span(place.truth).first(place.points.size());
    const std::span seen = std::span(looks.run->points).first(place.points.size());
    for (std::size_t i = 0; i < place.truth.size(); ++i) {
        const std::optional<double> error = relative_error(looks.run->points[i], place.truth[i]);
        const auto region = static_cast<std::size_t>(region_of(place, i));
        regions[region].add(error);
        ++result.asked[region];
        if (i >= truth.size()) {
            aerial[distance_of(place, i)].add(error);
            ++result.aerial_asked[distance_of(place, i)];
            continue;
        }
        all.add(error);
        if (error) colours.add(shown_difference(seen[i], truth[i].value, place.exposure));
    }
    result.all = all.summary();
    std::ranges::transform(regions, result.regions.begin(), &Errors::summary);
    std::ranges::transform(aerial, result.aerial.begin(), &Errors::summary);
    result.luminance_rmse = luminance_rmse(seen, truth);
    result.delta_e = colours.summary();
    result.sky_illuminance = luminance_error(looks.run->light.sky_irradiance_up, place.sky);
    result.sun_colour = relative_error(looks.run->light.sun_irradiance, place.sun);
    if (!looks.exact || !looks.converged) return result;
    split(place, looks, result);
    if (!place.scan.empty()) result.banding = banding_of(place, *looks.run, *looks.converged);
    return result;
}

}  // namespace aureole::app
