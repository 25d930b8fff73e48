#include "measure/compare.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>

using namespace aureole;
using namespace aureole::app;

namespace {

doctest::Approx near(double value) { return doctest::Approx(value).epsilon(1e-9).scale(1e-300); }

/// Points of a scene, each with radiance 1 of which nothing is uncertain.
Place white_place() {
    Place place;
    place.points = points_of(presets::earth().planet, 30, 0.002);
    place.truth.assign(place.points.size(), {Rgb(1), Rgb(0)});
    place.scan = scan_of(presets::earth().planet, 30, 0.002);
    place.exposure = 0.5;
    place.aerial = AerialView{30, 0.002, 60};
    place.truth.insert(place.truth.end(), aerial_pixels, {Rgb(1), Rgb(0)});
    for (std::size_t i = 0; i < aerial_pixels; ++i) {
        place.pixels.push_back(i);
        place.pixels_km.push_back(i % 3 == 0 ? 9.9 : 10.1);
    }
    place.sky = {Rgb(1), Rgb(0)};
    return place;
}

Seen all(const Place& place, double value) {
    return {std::vector(place.truth.size(), Rgb(value)), std::vector(place.scan.size(), Rgb(value)), {Rgb(value), Rgb(value)}};
}

}  // namespace

TEST_CASE("compare: each part is the distance to the next look") {
    const Place place = white_place();
    const Seen run = all(place, 1.07), exact = all(place, 1.06), fine = all(place, 1.02);
    const SceneResult result = compare(place, {&run, &exact, &fine});
    CHECK(result.all.median == near(0.07));
    CHECK(result.all.rows == place.points.size());
    REQUIRE(result.parts.has_value());
    CHECK(result.parts->rounding.worst == near(0.01));
    CHECK(result.parts->discretisation.median == near(0.04));
    CHECK(result.parts->model.p95 == near(0.02));
    CHECK(result.luminance_rmse.value() == near(0.07));
    CHECK(result.delta_e.median == near(shown_difference(Rgb(1.07), Rgb(1), 0.5)));
    CHECK(result.banding == 0.0);
    CHECK(result.sky_illuminance.value() == near(0.07));
    CHECK_FALSE(result.sun_colour.has_value());  // it has set
    const SceneResult total = compare(place, {&run});
    CHECK_FALSE(total.parts.has_value());
    CHECK_FALSE(total.banding.has_value());
    CHECK(total.all.median == result.all.median);
}

TEST_CASE("compare: geometry is told apart by its distance, and known or not for each") {
    Place place = white_place();
    Seen run = all(place, 1.2);
    for (std::size_t i = 0; i < aerial_pixels; i += 3) run.points[place.points.size() + i] = Rgb(1.1);
    place.truth[place.points.size()].error = Rgb(1);  // of one that is near
    const SceneResult result = compare(place, {&run});
    CHECK(result.aerial[0].median == near(0.1));
    CHECK(result.aerial[0].worst == near(0.1));
    CHECK(result.aerial[1].median == near(0.2));
    CHECK(result.aerial_asked[0] == aerial_pixels / 3);
    CHECK(result.aerial[0].rows + 1 == result.aerial_asked[0]);
    CHECK(result.aerial[1].rows == aerial_pixels - aerial_pixels / 3);
    CHECK(result.aerial[0].rows + result.aerial[1].rows == result.regions[static_cast<std::size_t>(Region::aerial)].rows);
}

TEST_CASE("compare: an error is counted in its region, and where the truth is unknown in none") {
    Place place = white_place();
    Seen run = all(place, 1);
    std::size_t nadir = 0;
    for (std::size_t i = 0; i < place.points.size(); ++i)
        if (place.points[i].region == Region::nadir) run.points[i] = Rgb(1.5), ++nadir;
    place.truth[0].error = Rgb(0.1);
    const SceneResult result = compare(place, {&run});
    const auto region = [&](Region r) { return result.regions[static_cast<std::size_t>(r)]; };
    CHECK(region(Region::nadir).rows == nadir);
    CHECK(region(Region::nadir).median == near(0.5));
    CHECK(region(Region::zenith).rows == 7);
    CHECK(region(Region::zenith).worst == 0);
    CHECK(region(Region::aerial).rows == aerial_pixels);
    CHECK(result.all.rows == place.points.size() - 1);
    CHECK(result.all.worst == near(0.5));
    CHECK(result.all.median == 0);
}

TEST_CASE("compare: bands are those of the scan alone") {
    const Place place = white_place();
    const Seen fine = all(place, 1);
    Seen run = fine;
    for (std::size_t i = 50; i < run.scan.size(); ++i) run.scan[i] = Rgb(1.2);
    const SceneResult result = compare(place, {&run, &fine, &fine});
    CHECK(result.banding.value() == near(shown_difference(Rgb(1), Rgb(1.2), 0.5)));
    CHECK(result.all.worst == 0);
    // Where the one row ends and the other begins there is no step.
    run = fine;
    for (std::size_t i = scan_up; i < run.scan.size(); ++i) run.scan[i] = Rgb(1.2);
    CHECK(compare(place, {&run, &fine, &fine}).banding == 0.0);
}
