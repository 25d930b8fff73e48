#include "planned_sky/place.h"

#include "plan/axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole::detail {
namespace {

/// The part of a range on its axis that is within `margin` of first to last, and these themselves where they are outside.
template <class ToAxis, class FromAxis>
PlanRange part_of(PlanRange range, PlanRange places, double margin, const ToAxis& to_axis, const FromAxis& from_axis) {
    const double least = to_axis(range.least), most = to_axis(range.most);
    const double low = std::max(places.least - margin, std::min(least, places.least));
    const double high = std::min(places.most + margin, std::max(most, places.most));
    const auto back = [&](double on_axis) {
        if (on_axis == least) return range.least;
        return on_axis == most ? range.most : from_axis(on_axis);
    };
    return {back(low), back(high)};
}

PlanRange clamped(PlanRange range, double least, double most) {
    range.least = std::clamp(range.least, least, most);
    return {range.least, std::clamp(range.most, range.least, most)};
}

}  // namespace

Place place_of(const Planet& planet, const Camera& camera, std::span<const Sun> suns, const Place& before) {
    const double distance = glm::length(camera.position_m);
    const glm::dvec3 up = distance > 0 ? camera.position_m / distance : glm::dvec3(0, 0, 1);
    Place place = before;
    place.altitude = altitude_axis(std::max(distance - planet.bottom_radius_m, -1e4), planet);
    if (suns.empty()) return place;
    const double night = sun_axis(night_deg);
    bool any = false;
    for (const Sun& sun : suns) {
        if (sun.irradiance == Rgb(0)) continue;
        const double sine = std::clamp(glm::dot(up, glm::normalize(sun.direction)), -1.0, 1.0);
        const double here = sun_axis(std::asin(sine) * 180 / std::numbers::pi);
        if (here < night) continue;
        place.lowest_sun = any ? std::min(place.lowest_sun, here) : here;
        place.highest_sun = any ? std::max(place.highest_sun, here) : here;
        any = true;
    }
    if (!any) place.lowest_sun = place.highest_sun = night;
    return place;
}

bool near(const Place& a, const Place& b, double margin) {
    const auto within = [&](double x, double y) { return std::abs(x - y) <= margin; };
    return within(a.lowest_sun, b.lowest_sun) && within(a.highest_sun, b.highest_sun) && within(a.altitude, b.altitude);
}

PlanRequirements around(const PlanRequirements& needs, const Place& place, double margin) {
    const Planet& planet = needs.air.planet;
    PlanRequirements part = needs;
    part.sun_elevation_deg =
        part_of(needs.sun_elevation_deg, {place.lowest_sun, place.highest_sun}, margin, sun_axis, elevation_of);
    part.sun_elevation_deg = clamped(part.sun_elevation_deg, -90, 90);
    part.altitude_m = part_of(
        needs.altitude_m, {place.altitude, place.altitude}, margin, [&](double m) { return altitude_axis(m, planet); },
        [&](double on_axis) { return altitude_of(on_axis, planet); });
    part.altitude_m = clamped(part.altitude_m, -1e4, 1e12);
    return part;
}

}  // namespace aureole::detail
