#include "measure/points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aureole::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double steps_a_degree = 1e4;

double rounded(double angle_deg) { return std::round(angle_deg * steps_a_degree) / steps_a_degree; }

/// Where the line of sight is tangent to a sphere of this radius, degrees from the zenith.
double tangent_deg(double camera_radius, double radius) {
    return 180 - std::asin(std::min(radius / camera_radius, 1.0)) / degree;
}

class Collector {
public:
    Collector(double sun_zenith_deg, double altitude_km) : sun_(sun_zenith_deg), altitude_(altitude_km) {}
    void add(Region region, double view_zenith_deg, double azimuth_deg) {
        points.push_back({region, {sun_, altitude_, rounded(view_zenith_deg), rounded(azimuth_deg)}});
    }
    std::vector<Point> points;

private:
    double sun_, altitude_;
};

void add_zenith(Collector& to) {
    constexpr int count = 8;
    constexpr double golden_deg = 137.50776, widest_deg = 40;
    for (int i = 0; i < count; ++i) {
        const double turn = std::fmod(golden_deg * (i + 0.5), 360);
        to.add(Region::zenith, widest_deg * std::sqrt((i + 0.5) / count), std::min(turn, 360 - turn));
    }
}

/// A direction so many degrees from the sun, sideways by `position_deg` from upwards.
void add_near_sun(Collector& to, double sun_zenith_deg, double apart_deg, double position_deg, double horizon_deg) {
    const double zs = sun_zenith_deg * degree, d = apart_deg * degree, p = position_deg * degree;
    const double cosine = std::cos(zs) * std::cos(d) + std::sin(zs) * std::sin(d) * std::cos(p);
    const double zenith = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double azimuth =
        std::atan2(std::sin(d) * std::sin(p), std::cos(d) * std::sin(zs) - std::sin(d) * std::cos(zs) * std::cos(p));
    if (zenith / degree < horizon_deg - 0.2) to.add(Region::aureole, zenith / degree, std::abs(azimuth) / degree);
}

void add_from_within(Collector& to, double sun_zenith_deg, double horizon_deg) {
    add_zenith(to);
    for (const double above : {0.3, 1.5, 5.0})
        for (const double azimuth : {10.0, 50.0, 90.0, 130.0, 170.0}) to.add(Region::horizon, horizon_deg - above, azimuth);
    // Of a sun that has set: of the place on the horizon where it has.
    const double seen_zenith = std::min(sun_zenith_deg, horizon_deg);
    for (const double apart : {0.6, 2.0, 5.0, 12.0})
        for (const double position : {20.0, 75.0}) add_near_sun(to, seen_zenith, apart, position, horizon_deg);
    for (const double above : {3.0, 8.0, 20.0})
        for (const double azimuth : {158.0, 180.0}) to.add(Region::antisolar, horizon_deg - above, azimuth);
}

/// Lines of sight that pass the ground at these shares of the air's depth.
void add_from_above(Collector& to, double bottom_km, double top_km, double camera_km) {
    for (const double share : {0.02, 0.08, 0.2, 0.4})
        for (const double azimuth : {10.0, 90.0, 170.0})
            to.add(Region::horizon, tangent_deg(camera_km, bottom_km + share * (top_km - bottom_km)), azimuth);
}

}  // namespace

std::vector<Point> points_of(const Planet& planet, double sun_zenith_deg, double altitude_km) {
    const double bottom = planet.bottom_radius_m / 1000, top = planet.top_radius_m / 1000, camera = bottom + altitude_km;
    const double horizon_deg = tangent_deg(camera, bottom);
    Collector to(sun_zenith_deg, altitude_km);
    if (camera < top)
        add_from_within(to, sun_zenith_deg, horizon_deg);
    else
        add_from_above(to, bottom, top, camera);
    for (const double share : {0.02, 0.1, 0.3, 0.6, 1.0})
        for (const double azimuth : {30.0, 150.0}) {
            if (share == 1.0 && azimuth != 30.0) continue;  // straight down: one direction
            to.add(Region::nadir, horizon_deg + share * (180 - horizon_deg), azimuth);
        }
    return to.points;
}

std::vector<ProbeRow> scan_of(const Planet& planet, double sun_zenith_deg, double altitude_km) {
    constexpr double apart_deg = 0.1, azimuth_deg = 60, across_deg = 15;
    const double bottom = planet.bottom_radius_m / 1000, camera = bottom + altitude_km;
    std::vector<ProbeRow> rows;
    if (camera >= planet.top_radius_m / 1000) return rows;
    const double horizon_deg = tangent_deg(camera, bottom);
    for (std::size_t i = 1; i <= scan_up; ++i)
        rows.push_back({sun_zenith_deg, altitude_km, rounded(horizon_deg - apart_deg * static_cast<double>(i)), azimuth_deg});
    for (std::size_t i = 0; i < scan_across; ++i)
        rows.push_back({sun_zenith_deg, altitude_km, rounded(horizon_deg - across_deg),
                        rounded(azimuth_deg + apart_deg * static_cast<double>(i))});
    return rows;
}

}  // namespace aureole::app
