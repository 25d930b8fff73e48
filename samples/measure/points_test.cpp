#include "measure/points.h"

#include <aureole/presets.h>

#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

using namespace aureole;
using namespace aureole::app;

namespace {

double angle_deg(const ProbeRow& row, double zenith_deg, double azimuth_deg) {
    const double cosine =
        glm::dot(probe_direction(row.view_zenith_deg, row.azimuth_deg), probe_direction(zenith_deg, azimuth_deg));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Zenith angle of the horizon, by the right triangle of camera, centre and point of tangency.
double horizon_deg(const Planet& planet, double altitude_km) {
    const double r = planet.bottom_radius_m, c = r + 1000 * altitude_km;
    return 90 + std::atan2(std::sqrt((c - r) * (c + r)), r) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("points: every region where it says, none twice, from every place") {
    for (const char* name : {"earth", "mars"}) {
        const Planet planet = presets::by_name(name).planet;
        for (const double altitude_km : {0.0, 0.002, 10.0, 400.0, 36000.0})
            for (const double sun : {0.0, 30.0, 85.0, 90.0, 94.0, 102.0}) {
                CAPTURE(altitude_km);
                CAPTURE(sun);
                const double horizon = horizon_deg(planet, altitude_km);
                const bool within = altitude_km < 100;
                std::array<int, region_names.size()> count{};
                std::set<std::array<double, 2>> seen;
                for (const Point& point : points_of(planet, sun, altitude_km)) {
                    ++count[static_cast<std::size_t>(point.region)];
                    CHECK_NOTHROW(check_row(point.row, "point"));
                    CHECK(point.row.sun_zenith_deg == sun);
                    CHECK(point.row.altitude_km == altitude_km);
                    CHECK(seen.insert({point.row.view_zenith_deg, point.row.azimuth_deg}).second);
                    const double above = horizon - point.row.view_zenith_deg;
                    CAPTURE(above);
                    CHECK((point.region == Region::nadir) == (above < 0));
                    if (point.region == Region::zenith) CHECK(point.row.view_zenith_deg <= 40);
                    if (point.region == Region::horizon && within) CHECK(above <= 5.0001);
                    if (point.region == Region::aureole) CHECK(angle_deg(point.row, std::min(sun, horizon), 0) < 12.001);
                    if (point.region == Region::antisolar) CHECK(point.row.azimuth_deg > 150);
                }
                CHECK(count[static_cast<std::size_t>(Region::zenith)] == (within ? 8 : 0));
                CHECK(count[static_cast<std::size_t>(Region::horizon)] == (within ? 15 : 12));
                CHECK(count[static_cast<std::size_t>(Region::antisolar)] == (within ? 6 : 0));
                CHECK(count[static_cast<std::size_t>(Region::nadir)] == 9);
                CHECK((count[static_cast<std::size_t>(Region::aureole)] >= 4) == within);
                CHECK(count[static_cast<std::size_t>(Region::aerial)] == 0);
            }
    }
}

TEST_CASE("points: from above the air the band is the air beyond the limb") {
    const Planet planet = presets::earth().planet;
    const double camera = planet.bottom_radius_m + 400e3;
    for (const Point& point : points_of(planet, 30, 400)) {
        if (point.region != Region::horizon) continue;
        const double tangent = camera * std::sin(point.row.view_zenith_deg * std::numbers::pi / 180) - planet.bottom_radius_m;
        CHECK(tangent > 1900);
        CHECK(tangent < 41000);
    }
}

TEST_CASE("points: a scan is evenly spaced, above the horizon, and only within the air") {
    const Planet planet = presets::earth().planet;
    const std::vector<ProbeRow> scan = scan_of(planet, 60, 10);
    REQUIRE(scan.size() == scan_up + scan_across);
    const double horizon = horizon_deg(planet, 10);
    CHECK(scan.front().view_zenith_deg == doctest::Approx(horizon - 0.1).epsilon(1e-6).scale(1e-300));
    for (std::size_t i = 1; i < scan_up; ++i)
        CHECK(scan[i - 1].view_zenith_deg - scan[i].view_zenith_deg == doctest::Approx(0.1).epsilon(2e-3).scale(1e-300));
    for (std::size_t i = scan_up + 1; i < scan.size(); ++i)
        CHECK(scan[i].azimuth_deg - scan[i - 1].azimuth_deg == doctest::Approx(0.1).epsilon(1e-6).scale(1e-300));
    CHECK(scan_of(planet, 60, 400).empty());
}
